#!/usr/bin/env bash
# Prints every change of every job, as it happens, or of one job until it has ended: one line of JSON each.
# usage: watch_events.sh SERVER [JOB_ID]
# After a broken connection it asks for what it has missed. Exit code: 0 the job has ended, 1 there is none, 2 wrong usage.
# shellcheck source-path=SCRIPTDIR source=floeplan.sh
source "$(dirname "${BASH_SOURCE[0]}")/floeplan.sh"

if (($# < 1 || $# > 2)); then
  echo "usage: watch_events.sh SERVER [JOB_ID]" >&2
  exit 2
fi
server=${1%/}
address=$server/events
if (($# == 2)); then
  address=$server/jobs/$2/events
  ask "$server/jobs/$2" >/dev/null
fi

seen=
while true; do
  # The server says something every 15 seconds; a minute of silence is a broken connection.
  while IFS= read -r line; do
    case $line in
      'id: '*) seen=${line#id: } ;;
      'data: '*) printf '%s\n' "${line#data: }" ;;
    esac
  done < <(curl --silent --no-buffer --speed-limit 1 --speed-time 60 \
    --header @<(if [[ -n ${FLOEPLAN_TOKEN-} ]]; then echo "Authorization: Bearer $FLOEPLAN_TOKEN"; fi) \
    ${seen:+--header "Last-Event-ID: $seen"} "$address")
  if (($# == 2)); then
    case $(ask "$server/jobs/$2" | text_of status) in accepted | running) ;; *) exit 0 ;; esac
  fi
  sleep 2
done
