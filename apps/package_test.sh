#!/usr/bin/env bash
# Makes the package, installs it on an empty Debian 12 without compiler, runs the demo there as a plain user, by the command and by
# Python, a scene of `reye new` and the examples of Python, and removes the root.
#
#   package_test.sh BUILD OUT   the package, its runs (demo, demo_python) and figures.txt, a line `name number` each, are left in OUT
#
# As root, with debootstrap and dpkg-dev; packages come from the mirror of this machine. 77: one of these is missing.
set -euo pipefail
[ $# -eq 2 ] || { sed -n '2,7s/^# \{0,1\}//p' "$0"; exit 2; }
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap dpkg-shlibdeps unshare >/dev/null; then
  echo "package_test: root, debootstrap and dpkg-dev are needed" >&2
  exit 77
fi
build=$(realpath "$1")
mkdir -p "$2"
out=$(realpath "$2")
root=$(mktemp -d)
chmod 755 "$root"   # other users look into it, too
trap 'rm -rf --one-file-system "$root"' EXIT

mirror() {
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' | head -n 1
}

# A command in the root, with /proc of its own, which ends with it.
inside() {
  unshare --mount --pid --fork --mount-proc="$root/proc" \
    chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"
}

# figure NAME NUMBER; a command that fails must have ended before, so its number comes from a variable.
figure() { echo "$1 $2" | tee -a "$out/figures.txt"; }
megabytes() { du -sm --one-file-system "$1" | cut -f 1; }
packages() { inside dpkg-query -W | wc -l; }

# Seconds that a command takes; its words go to the log.
seconds() {
  local start=$EPOCHREALTIME
  "$@" >>"$out/log.txt" 2>&1 </dev/null || { tail -n 20 "$out/log.txt" >&2; return 1; }
  echo "$EPOCHREALTIME $start" | awk '{ printf "%.1f", $1 - $2 }'
}

rm -rf "$out"/{demo,demo_python,figures.txt,log.txt} "$out"/reye_*.deb
(cd "$build" && cpack -G DEB -B "$out" >"$out/log.txt")
rm -rf "$out/_CPack_Packages"
package=$(basename "$out"/reye_*.deb)
figure package_MB "$(du -k "$out/$package" | awk '{ printf "%.1f", $1 / 1024 }')"

seconds debootstrap --variant=minbase bookworm "$root" "$(mirror)" >/dev/null
before_MB=$(megabytes "$root") before_packages=$(packages)
cp "$out/$package" "$root/var/tmp/"
took=$(seconds inside apt-get install -y "/var/tmp/$package")
figure install_s "$took"
inside apt-get clean
figure installed_MB $(($(megabytes "$root") - before_MB))
figure installed_packages $(($(packages) - before_packages))
! inside sh -c 'command -v gcc g++ cc cmake' || { echo "package_test: the root has a compiler" >&2; exit 1; }

inside useradd --create-home visitor
visitor() { inside su visitor -c "cd && $1"; }
took=$(seconds visitor 'reye run /usr/share/reye/geo/fretting_demo/scene.toml --out demo --quiet')
figure run_s "$took"
took=$(seconds visitor "python3 -c 'import reye; reye.Scene(\"/usr/share/reye/geo/fretting_demo/scene.toml\").run(out=\"demo_python\")'")
figure python_run_s "$took"
cp -r "$root"/home/visitor/{demo,demo_python} "$out"
for example in "$root"/usr/share/reye/apps/python/examples/*.py; do
  seconds visitor "python3 ${example#"$root"}" >/dev/null
done
figure examples "$(ls "$root"/usr/share/reye/apps/python/examples/*.py | wc -l)"
took=$(seconds visitor 'reye new mine --like seal && reye check mine/scene.toml && reye run mine/scene.toml --out mine.out --quiet')
figure new_s "$took"

seconds inside apt-get install -y --no-install-recommends lintian >/dev/null
inside su visitor -c "lintian --fail-on none /var/tmp/$package" >"$out/lintian.txt"
figure lintian_errors "$(grep -c '^E:' "$out/lintian.txt" || true)"
