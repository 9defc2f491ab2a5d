#!/usr/bin/env bash
# Puts a backup in the place of a store. The server must be stopped; what was there before is kept beside it.
# usage: restore.sh BACKUP STORE      the program is `floeplan`, or what the variable FLOEPLAN names
#        restore.sh FOLDER STORE      the newest backup in a folder that backup.sh filled
set -euo pipefail

fail() {
  printf 'floeplan: %s; %s\n' "$1" "$2" >&2
  exit 1
}

main() {
  local program=${FLOEPLAN:-floeplan} backup=${1-} store=${2-}
  [[ -n $backup && -n $store ]] || fail "a backup and a store are needed" "use: restore.sh BACKUP STORE"
  if [[ -d $backup ]]; then
    local folder=$backup
    backup=$(find "$folder" -maxdepth 1 -name 'floeplan-*Z.sqlite' | sort | tail -n 1)
    [[ -n $backup ]] || fail "there is no backup in $folder" "name another folder, or a file"
  fi
  "$program" --data "$store" restore "$backup"
}

main "$@"
