# An image with the built package. Examples (docs/install.md):
#   docker build -t collision_forge .
#   docker run --rm -v "$PWD:/data" collision_forge forge convert --source /data/nuscenes --out /data/bags
FROM debian:12
COPY . /collision_forge
WORKDIR /collision_forge
RUN scripts/setup && apt-get clean && rm -rf /var/lib/apt/lists/*
ENTRYPOINT ["/bin/bash", "-c", "source /collision_forge/scripts/env.bash && cd /data 2> /dev/null; exec \"$@\"", "--"]
CMD ["forge", "--help"]
