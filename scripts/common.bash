# Functions shared by the scripts of this folder: packages, configuration, build, ROS environment.
# To be sourced by bash scripts with `set -euo pipefail`; defines functions and variables only.
# shellcheck shell=bash

REPO_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
BUILD_DIR=$REPO_ROOT/build
DEVEL_DIR=$REPO_ROOT/devel # not inside build/, where rosrun does not search for programs
MEMORY_PER_JOB_KIB=$((3 * 512 * 1024)) # 1.5 GiB: a file that includes torch needs 1.1 GB

say() { printf '%s\n' "-- $*" >&2; }

die() {
  printf '%s\n' "error: $*" >&2
  exit 1
}

# Prints the error and exits 2, the exit code of a wrong command line.
die_usage() {
  printf '%s\n' "error: $*" "try: $0 --help" >&2
  exit 2
}

# Prints the comment at the top of the calling script: its help text.
print_usage() { sed -n '2,/^$/s/^# \{0,1\}//p' "$0"; }

refuse_arguments() {
  [[ ${1:-} != --help && ${1:-} != -h ]] || { print_usage && exit 0; }
  [[ $# -eq 0 ]] || die_usage "unknown argument: $1"
}

# ---- packages ----

# listed_packages forge|all|interop|pictures|sanitize: prints packages of packages.txt: its first part for forge, its
# first two parts for all, and for other names these two and the part of that name.
listed_packages() {
  local parts=forge
  [[ $1 == forge ]] || parts="forge|rest|$1"
  awk -v parts="^($parts):$" '/^# ====/ { wanted = $3 ~ parts } { sub(/#.*/, "") } wanted' \
    "$REPO_ROOT/scripts/packages.txt" | xargs -n 1
}

missing_packages() {
  local installed
  installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | sort -u)
  comm -23 <(listed_packages "$1" | sort -u) <(printf '%s\n' "$installed")
}

# install_packages forge|all|interop|pictures|sanitize
install_packages() {
  { command -v dpkg-query && command -v apt-get; } > /dev/null ||
    die "this is not a Debian system: install the packages of scripts/packages.txt with your package manager"
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$1")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  if [[ $EUID -ne 0 ]]; then
    command -v sudo > /dev/null || die "neither root nor sudo; as root: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${#missing[@]} missing packages: ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=600)
  "${apt[@]}" update >&2 || die "apt-get update failed"
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >&2 || die "apt-get install failed"
}

# ---- build ----

# With precompiled headers, ccache has hits only if it ignores these differences.
export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros,include_file_mtime,include_file_ctime}

# ROS and catkin need the system's python3, even if another python is first in PATH.
use_system_python() {
  export PATH=/usr/bin:$PATH
  unset PYTHONHOME
}

# Prints the number of parallel compilers: one per core, fewer if memory is short. CMAKE_BUILD_PARALLEL_LEVEL overrides.
parallel_jobs() {
  local available_kib by_memory cores
  available_kib=$(awk '/^MemAvailable:/ {print $2}' /proc/meminfo)
  by_memory=$((available_kib / MEMORY_PER_JOB_KIB))
  cores=$(nproc)
  echo $((by_memory < 1 ? 1 : by_memory < cores ? by_memory : cores))
}

cached() { sed -n "s/^$1:[A-Z]*=//p" "$BUILD_DIR/CMakeCache.txt" 2> /dev/null || true; }

# True if the build folder was configured for another path, with other basic settings, or without success.
build_folder_is_stale() {
  [[ -e $BUILD_DIR/CMakeCache.txt ]] || return 1
  [[ $(cached CMAKE_HOME_DIRECTORY) != "$REPO_ROOT" || $(cached CMAKE_CACHEFILE_DIR) != "$BUILD_DIR" ||
    $(cached CMAKE_GENERATOR) != Ninja || $(cached PYTHON_EXECUTABLE) != /usr/bin/python3 ||
    $(cached CATKIN_DEVEL_PREFIX) != "$DEVEL_DIR" || ! -e $BUILD_DIR/build.ninja ]]
}

# configure OPTION...: runs CMake with these options and the common ones.
configure() {
  if build_folder_is_stale; then
    say "removing $BUILD_DIR and $DEVEL_DIR: configured for another folder, with other settings, or incompletely"
    rm -rf "$BUILD_DIR" "$DEVEL_DIR"
  fi
  local log=$BUILD_DIR/configure.log
  mkdir -p "$BUILD_DIR"
  say "configuring $BUILD_DIR"
  cmake -S "$REPO_ROOT" -B "$BUILD_DIR" -G Ninja -DCATKIN_DEVEL_PREFIX="$DEVEL_DIR" \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)" "$@" > "$log" 2>&1 || {
    cat "$log" >&2
    die "cmake failed (its output is above and in $log)"
  }
}

# build TARGET...
build() {
  local jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(parallel_jobs)}
  say "building $* with $jobs job(s)"
  cmake --build "$BUILD_DIR" -j "$jobs" --target "$@" >&2 || die "the build failed"
}

# prepare_forge: installs packages and builds the program forge. A folder configured for all targets stays so.
prepare_forge() {
  local only=ON
  if ! build_folder_is_stale && [[ $(cached COLLISION_FORGE_PROGRAM_ONLY) == OFF ]]; then only=OFF; fi
  install_packages forge
  use_system_python
  configure -DCOLLISION_FORGE_PROGRAM_ONLY="$only"
  build forge
}

# prepare_all [OPTION_OF_CMAKE...] -- TARGET...: installs packages, configures all targets and builds TARGET...
prepare_all() {
  local options=()
  while [[ ${1?prepare_all: no -- before the targets} != -- ]]; do options+=("$1") && shift; done
  shift
  install_packages all
  use_system_python
  configure -DCOLLISION_FORGE_PROGRAM_ONLY=OFF "${options[@]}"
  build "$@"
}

# use_sanitizer_build KIND: selects the build folder of a sanitizer for the following calls. It is inside build/, where
# rosrun does not search: otherwise rosrun would find two programs of each name.
use_sanitizer_build() {
  BUILD_DIR=$REPO_ROOT/build/sanitize/$1
  DEVEL_DIR=$BUILD_DIR/devel
}

# ---- ROS ----

# Sources env.bash without `set -eu`, which catkin's own files do not support.
use_ros_environment() {
  set +eu
  # shellcheck source=scripts/env.bash
  source "$REPO_ROOT/scripts/env.bash" || exit 1
  set -eu
}

# isolate_ros HOME: removes the caller's ROS settings, because tests start their own masters and nodes.
isolate_ros() {
  local home=$1
  unset ROS_IP ROS_LOG_DIR ROS_NAMESPACE ROSCONSOLE_CONFIG_FILE
  export ROS_HOME=$home ROS_HOSTNAME=localhost
}
