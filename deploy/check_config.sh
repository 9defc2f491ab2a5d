#!/usr/bin/env bash
# Has nginx, Caddy, systemd, Prometheus and Kubernetes read the files that are meant for them. What is not installed is named and left out.
# usage: deploy/check_config.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

check_nginx() {
  openssl req -x509 -newkey rsa:2048 -nodes -days 1 -subj /CN=plan.example.org \
    -keyout "$work/key.pem" -out "$work/chain.pem" 2>/dev/null
  sed "s#\(ssl_certificate_key \).*#\1$work/key.pem;#; s#\(ssl_certificate \).*#\1$work/chain.pem;#" \
    "$root/deploy/nginx.conf" >"$work/site.conf"
  printf 'pid %s/pid;\nevents {}\nhttp { include %s/site.conf; }\n' "$work" "$work" >"$work/nginx.conf"
  nginx -t -q -c "$work/nginx.conf"
}

check_caddy() {
  HOME=$work caddy validate --adapter caddyfile --config "$root/deploy/Caddyfile" >/dev/null 2>"$work/caddy.log" ||
    { cat "$work/caddy.log" >&2 && return 1; }
}

check_systemd() {
  local unit
  for unit in floeplan.service floeplan-worker.service floeplan-backup.service floeplan-backup.timer; do
    sed "s#^Exec\(.*\)=[^ ]*#Exec\1=/bin/true#; s#^\(User\|Group\)=.*#\1=root#" "$root/deploy/$unit" >"$work/$unit"
  done
  systemd-analyze verify "$work"/floeplan*.service "$work"/floeplan*.timer
  # In tenths: what the unit leaves open, of 10.
  for unit in floeplan.service floeplan-worker.service; do
    systemd-analyze security --offline=true --threshold=16 "$root/deploy/$unit" >"$work/exposure" ||
      { tail -n 1 "$work/exposure" >&2 && return 1; }
  done
}

# Without a cluster: that every object of the manifest is one that Kubernetes knows.
check_kubectl() { kubectl label --local -f "$root/deploy/kubernetes.yaml" checked=yes -o name >/dev/null; }

check_promtool() { promtool check rules "$root/deploy/alerts.yaml" >/dev/null; }

main() {
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  local program
  for program in nginx caddy systemd-analyze promtool kubectl; do
    if ! command -v "$program" >/dev/null; then
      say "$program is not installed: its files were not checked"
      continue
    fi
    run_or_fail "$program refuses its file" "read its message above" "check_${program%-analyze}"
    say "$program takes its file"
  done
}

main "$@"
