# Completion of reye for bash: commands, options, scenes (*.toml) and folders. Nothing is run for it; a test compares the
# words with the help of the program.
_reye() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words=
  local -A options=(
    [run]="--out --restart --force --quiet --threads --trust-geometry --help"
    [plan]="--trial --threads --trust-geometry --help"
    [check]="--picture --trust-geometry --help"
    [mesh]="--out --trust-geometry --help"
    [sweep]="--vary --out --jobs --member --slurm --table --force --quiet --trust-geometry --help"
    [calibrate]="--measured --at --contact --side --free --out --threads --force --quiet --trust-geometry --help"
    [new]="--like --out --list --help"
    [export]="--format --cycle --frame --body --thickness --out --list --force --help"
    [report]="--animation --help"
  )
  COMPREPLY=()
  compopt +o filenames 2>/dev/null
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "${!options[*]} --help --version" -- "$word")
    return
  fi
  case $before in
    --threads | --trial | --jobs | --member | --vary | --at | --contact | --free | --cycle | --frame | --body | --thickness) return ;;
    --like)
      mapfile -t COMPREPLY < <(compgen -W "fretting bearing pin_on_disc block_on_ring seal dovetail hip_cup ball_on_flat" -- "$word")
      return ;;
    --format)
      mapfile -t COMPREPLY < <(compgen -W "csv dxf step stl" -- "$word")
      return ;;
    --side)
      mapfile -t COMPREPLY < <(compgen -W "secondary primary" -- "$word")
      return ;;
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${options[${COMP_WORDS[1]}]-}" -- "$word")
    return
  fi
  case $before:${COMP_WORDS[1]} in
    --out:* | *:report | *:export | *:new) ;;
    --picture:*) words='!*.svg' ;;
    --measured:*) words='!*.@(csv|toml)' ;;
    *) words='!*.toml' ;;
  esac
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word"; [[ -z $words ]] || compgen -f -X "$words" -- "$word")
}
complete -F _reye reye
