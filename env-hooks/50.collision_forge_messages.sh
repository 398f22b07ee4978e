# Puts the stand-ins for messages that Debian does not have last in PYTHONPATH: a real package comes first.
_collision_forge_messages=$CATKIN_ENV_HOOK_WORKSPACE/share/collision_forge/other_messages
case :${PYTHONPATH:-}: in
  *":$_collision_forge_messages:"*) ;;
  *) export PYTHONPATH="${PYTHONPATH:+$PYTHONPATH:}$_collision_forge_messages" ;;
esac
unset _collision_forge_messages
