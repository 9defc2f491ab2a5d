#!/usr/bin/env bash
# Plans a route as a job, waits for it and prints the plan.
# usage: plan_and_wait.sh SERVER INPUTS.json     INPUTS.json: the inputs of process plan-route
# Exit code: 0 there is a plan, 1 there is none (the answer says why), 2 wrong usage.
# shellcheck source-path=SCRIPTDIR source=floeplan.sh
source "$(dirname "${BASH_SOURCE[0]}")/floeplan.sh"

if (($# != 2)); then
  echo "usage: plan_and_wait.sh SERVER INPUTS.json" >&2
  exit 2
fi
server=${1%/}

# With a key of its own the request can be sent again after a broken connection, and is still one job.
job=$({ printf '{"inputs": ' && cat "$2" && printf '}'; } |
  ask "$server/processes/plan-route/execution" --data-binary @- --header 'Content-Type: application/json' \
    --header 'Prefer: respond-async' --header "Idempotency-Key: $(cat /proc/sys/kernel/random/uuid)" | text_of jobID)
ended=$(wait_for "$server" "$job")
[[ $ended == successful ]] || fail "the job ended $ended: $(ask "$server/jobs/$job" | text_of message)"
results=$(ask "$server/jobs/$job/results")
printf '%s\n' "$results"
[[ -n $(text_of plan_id <<<"$results") ]]
