#!/usr/bin/env bash
# Completes in a shell with the script that an installation put where this shell looks for it.
#
#   check_completion.sh bash|zsh|fish PREFIX
set -euo pipefail

shell=${1:?"usage: check_completion.sh bash|zsh|fish PREFIX"}
prefix=${2:?"usage: check_completion.sh bash|zsh|fish PREFIX"}
command -v "$shell" > /dev/null || { echo "skipped: $shell is not installed"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" # without files whose names could be offered
export HOME=$work PATH=$prefix/bin:$PATH XDG_DATA_DIRS=$prefix/share:/usr/local/share:/usr/share TERM=dumb

# Each prints what the shell offers after "gonio uni", after "gonio import --to us" and after "gonio list sta".
case $shell in
bash)
    [[ -f /usr/share/bash-completion/bash_completion ]] || { echo 'skipped: bash-completion is not installed'; exit 77; }
    cat > "$work/try" << 'TRY'
source /usr/share/bash-completion/bash_completion
try() {
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
    _gonio
    echo "${COMPREPLY[@]}"
}
_completion_loader gonio # which finds it as Tab does; 124 says: try again
[[ $(complete -p gonio) == *_gonio* ]] || exit 1
try gonio uni
try gonio import --to us
try gonio list sta
TRY
    bash --norc "$work/try" > "$work/said"
    ;;
zsh)
    # A terminal in which keys are typed: completion in zsh has no other door. The answer is what the line has become.
    cat > "$work/try" << TRY
zmodload zsh/zpty
try() {
    zpty shell zsh -f -i
    zpty -w shell "PS1=; fpath=('$prefix/share/zsh/site-functions' \\\$fpath); autoload -Uz compinit; compinit -u -D"
    zpty -w shell 'show() { print -r -- "line:\$BUFFER:" > $work/line; }; zle -N show; bindkey "^X" show'
    zpty -w -n shell "\$1"\$'\\t\\x18'
    repeat 100; do
        [[ -s $work/line ]] && break
        sleep 0.1
    done
    sed -E 's/^line:(.*):\$/\\1/; s/.* ([^ ]+) *\$/\\1/' $work/line
    rm -f $work/line
    zpty -d shell
}
try 'gonio uni'
try 'gonio import --to us'
try 'gonio list sta'
TRY
    zsh -f "$work/try" > "$work/said"
    ;;
fish)
    for line in 'gonio uni' 'gonio import --to us' 'gonio list sta'; do
        fish --private --command "complete -C '$line'" | cut -f 1
    done > "$work/said"
    ;;
*)
    echo "no shell '$shell'" >&2
    exit 2
    ;;
esac
diff <(printf 'units\nusd\nstages\n') "$work/said"
echo "$shell completes commands, values and lists"
