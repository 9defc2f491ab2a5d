#!/usr/bin/env bash
# Sends files to the server and has them ingested together: a forecast's U and V files, a chart and its updates.
# usage: nightly_ingest.sh SERVER FILE...
# For cron, after the download:  17 3 * * *  nightly_ingest.sh http://127.0.0.1:8080 /data/today/*.nc
# Exit code: 0 everything is stored, 1 could not be done, 2 wrong usage, 3 a file was refused (the others are stored).
# shellcheck source-path=SCRIPTDIR source=floeplan.sh
source "$(dirname "${BASH_SOURCE[0]}")/floeplan.sh"

if (($# < 2)); then
  echo "usage: nightly_ingest.sh SERVER FILE..." >&2
  exit 2
fi
server=${1%/}
shift

uploads=
for file in "$@"; do
  digest=$(sha256sum "$file" | cut -d ' ' -f 1)
  # What arrives with another digest is refused. The file is sent from the disk, whatever its size.
  id=$(ask "$server/uploads?sha256=$digest" --request POST --upload-file "$file" --url-query "name=$(basename "$file")" |
    text_of id)
  uploads+=${uploads:+, }\"$id\"
done
job=$(ask "$server/processes/ingest/execution" --data "{\"inputs\": {\"uploads\": [$uploads]}}" \
  --header 'Content-Type: application/json' --header 'Prefer: respond-async' | text_of jobID)
ended=$(wait_for "$server" "$job")
[[ $ended == successful ]] || fail "the job ended $ended: $(ask "$server/jobs/$job" | text_of message)"
report=$(ask "$server/jobs/$job/results")
printf '%s\n' "$report"
if grep -q '"status": *"refused"' <<<"$report"; then exit 3; fi
