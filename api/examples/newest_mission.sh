#!/usr/bin/env bash
# Fetches the mission files of the plan that was made last, as an archive PLAN.zip in a folder.
# usage: newest_mission.sh SERVER FOLDER
# Exit code: 0 fetched (prints the archive's path), 1 not, 2 wrong usage.
# shellcheck source-path=SCRIPTDIR source=floeplan.sh
source "$(dirname "${BASH_SOURCE[0]}")/floeplan.sh"

if (($# != 2)); then
  echo "usage: newest_mission.sh SERVER FOLDER" >&2
  exit 2
fi
server=${1%/}
folder=$2

plan=
address="$server/collections/plans/items?limit=1000"
while [[ -n $address ]]; do # plans come in the order in which they were made
  page=$(ask "$address")
  last=$({ grep -o '"plan_id": *"[^"]*"' <<<"$page" || true; } | tail -n 1 | text_of plan_id)
  plan=${last:-$plan}
  address=$({ grep -o '"href": *"[^"]*[?&]after=[^"]*"' <<<"$page" || true; } | text_of href)
done
[[ -n $plan ]] || fail "the server holds no plan"
mkdir -p "$folder"
ask "$server/collections/plans/items/$plan/mission.zip" --output "$folder/$plan.zip.part" >/dev/null
mv "$folder/$plan.zip.part" "$folder/$plan.zip"
echo "$folder/$plan.zip"
