# What bash offers on the command line of mapwright. The program tells it itself, by --help.
_mapwright() {
  local cur=$2 prev=$3 command=() help word i
  local -r value='(,[^ ]*)? (TEXT|FLOAT|INT|UINT|ENUM|ADDRESS|FILE|DIR|TIME|DURATION)'
  help=$'\n'$("$1" --help 2>/dev/null)
  for ((i = 1; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ $word == -* ]]; then
      [[ $help =~ $'\n  '([^ ]*,)?"$word"$value ]] && ((i++))
    elif [[ $help == *$'\nSubcommands:'*$'\n  '"$word "* ]]; then
      command+=("$word")
      help=$'\n'$("$1" "${command[@]}" --help 2>/dev/null)
    fi
  done
  local offers=() in=
  while IFS= read -r word; do
    if [[ $word == [A-Z]*: ]]; then
      in=$word
    elif [[ $prev == -* && $word =~ ^\ \ ([^ ]*,)?"$prev"$value(.*) ]]; then
      # The words that it may be, where it is one of some; else a file.
      offers=()
      if [[ ${BASH_REMATCH[4]} =~ \{([^}]+)\} ]]; then
        IFS=, read -ra offers <<<"${BASH_REMATCH[1]}"
        offers=("${offers[@]%%->*}")
      fi
      break
    elif [[ $cur == -* && $word =~ ^\ \ (-[^ ]*) ]]; then
      word=${BASH_REMATCH[1]%%\{*}
      offers+=("${word##*,}")
    elif [[ $cur != -* && $in == Subcommands: && $word =~ ^\ \ ([^ ]+) ]]; then
      offers+=("${BASH_REMATCH[1]}")
    fi
  done <<<"$help"
  COMPREPLY=($(compgen -W "${offers[*]}" -- "$cur"))
}
complete -o default -F _mapwright mapwright
