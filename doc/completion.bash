# Completion in bash of 'stiction', where it is installed, and of './run' after
# 'source doc/completion.bash': commands, files, options, and after --set the entries
# Section/Entry, all as the two print them.
_stiction() {
  [ "$1" = ./run ] && [ "$PWD" != "$_stiction_root" ] && return # another ./run
  local word=${COMP_WORDS[COMP_CWORD]} program=$1 words one IFS=$'\n'
  [ "$1" = ./run ] && program=build/stiction
  if [ "${COMP_WORDS[COMP_CWORD - 1]}" = --set ]; then
    words=($("$program" --print-parameters 2>/dev/null | awk '
      $1 == "subsection" { sub(/^ *subsection /, ""); path = path $0 "/" }
      $1 == "end" { sub(/[^\/]*\/$/, "", path) }
      $1 == "set" { sub(/^ *set /, ""); sub(/ *=.*/, "="); print path $0 }'))
  elif [[ $word == -* ]]; then
    words=($("$program" --help 2>/dev/null | grep -o -- '--[a-z-]*' | sort -u))
    [ "$1" = ./run ] && words+=(-n --picture)
  else
    words=($(compgen -f -X '!*.prm' -- "$word") $(compgen -d -S / -- "$word"))
    [ "$1$COMP_CWORD" = ./run1 ] &&
      words+=($(./run --help | sed -n 's/^ *\.\/run \([a-z]*\) .*/\1/p'))
  fi
  COMPREPLY=()
  for one in "${words[@]}"; do
    printf -v one %q "$one" # entries have spaces
    [[ $one == *[=/] ]] || one+=" "
    [[ $one == "$word"* ]] && COMPREPLY+=("$one")
  done
}
_stiction_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
complete -o nospace -F _stiction stiction
[ -x "$_stiction_root/run" ] && complete -o nospace -F _stiction ./run
