#!/usr/bin/env bash
# Copies a store while its server works, into a file named by the time, and keeps the newest copies.
# usage: backup.sh STORE FOLDER [COPIES_TO_KEEP]      the program is `floeplan`, or what the variable FLOEPLAN names
set -euo pipefail

fail() {
  printf 'floeplan: %s; %s\n' "$1" "$2" >&2
  exit 1
}

main() {
  local program=${FLOEPLAN:-floeplan} store=${1-} folder=${2-} keep=${3-14}
  [[ -n $store && -n $folder ]] || fail "a store and a folder are needed" "use: backup.sh STORE FOLDER [COPIES_TO_KEEP]"
  [[ $keep =~ ^[1-9][0-9]*$ ]] || fail "$keep copies cannot be kept" "give a number of at least 1"
  mkdir -p "$folder"
  local copy
  copy=$folder/floeplan-$(date -u +%Y%m%dT%H%M%SZ).sqlite
  "$program" --data "$store" backup "$copy"
  find "$folder" -maxdepth 1 -name 'floeplan-*Z.sqlite' | sort -r | tail -n "+$((keep + 1))" | while read -r old; do
    rm -- "$old"
  done
}

main "$@"
