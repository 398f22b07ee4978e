# usage: source scripts/env.bash      (bash, after scripts/setup, or after scripts/demo for forge alone)
#
# Sets up this shell for the built package: rosrun, roslaunch, rosservice, rviz and forge, with completion of forge's
# arguments. Puts /usr/bin first in PATH, because ROS needs the system's python3. Does not change ROS_MASTER_URI.
# Sets ROS_HOSTNAME to localhost unless ROS_HOSTNAME or ROS_IP is set, and ROS_HOME to build/ros_home unless set.
# shellcheck shell=bash

if [[ ${BASH_SOURCE[0]} == "$0" ]]; then
  echo "env.bash must be sourced: source ${BASH_SOURCE[0]}" >&2
  exit 2
fi

# Moves a folder to the front of PATH.
_collision_forge_path_first() {
  local path=:$PATH:
  path=${path//":$1:"/:}
  path=${path#:}
  PATH=$1:${path%:}
}

_collision_forge_environment() {
  local root
  root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
  if [[ ! -e $root/devel/setup.bash ]]; then
    echo "env.bash: $root/devel/setup.bash is missing: run scripts/setup first" >&2
    return 1
  fi
  _collision_forge_path_first /usr/bin
  # shellcheck disable=SC1091
  source "$root/devel/setup.bash" || return 1
  _collision_forge_path_first "$root/devel/bin"
  _collision_forge_path_first /usr/bin
  export PATH
  [[ -n ${ROS_HOSTNAME:-}${ROS_IP:-} ]] || export ROS_HOSTNAME=localhost
  export ROS_HOME=${ROS_HOME:-$root/build/ros_home}
  mkdir -p "$ROS_HOME"
}

# Loads the completion of forge on first use. Exit status 124 makes bash retry with the loaded completion.
_collision_forge_completion() {
  # shellcheck disable=SC1090
  source <(forge completion bash) && return 124
}
complete -F _collision_forge_completion forge

_collision_forge_environment
