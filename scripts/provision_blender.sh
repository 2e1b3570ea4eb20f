#!/bin/sh
# SPDX-License-Identifier: MIT OR Apache-2.0
# Puts a real Blender with a virtual screen into a chroot, for the third ring of tests.
#
#   scripts/provision_blender.sh DIR SUITE     SUITE: trixie (Blender 4.3) or sid (Blender 5.2)
#
# DIR becomes the chroot, with a log beside it. Packages come from the mirror that this machine's apt uses.
# Running it again is quick: a finished chroot is left as it is. No mount is left behind; scripts/enter_chroot.sh
# makes those it needs.
# Exit codes: 0 ready, 1 failed on the way, 3 this machine cannot have one (one sentence says why).
set -eu

cannot() {
    echo "provision_blender: $1" >&2
    exit 3
}

[ $# -eq 2 ] || { echo "usage: $0 DIR trixie|sid" >&2; exit 2; }
case "$2" in trixie|sid) ;; *) echo "usage: $0 DIR trixie|sid" >&2; exit 2 ;; esac
suite=$2
mkdir -p "$(dirname "$1")"
root=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
log=$root.log
here=$(cd "$(dirname "$0")" && pwd)

packages="blender python3-numpy python3-cattr python3-requests xvfb xauth libgl1-mesa-dri libegl1 mesa-vulkan-drivers
          xdotool imagemagick x11-utils"
stamp=$root/.boxmorph-provisioned
wanted=$(echo "$packages" | tr -s '[:space:]' ' ')

[ "$(id -u)" = 0 ] || cannot "real Blender is tested in a chroot, which needs root; run as root or leave these tests out."
command -v apt-get >/dev/null || cannot "real Blender is taken from Debian's packages, and this machine has no apt-get."
unshare --mount true 2>/dev/null || cannot "this machine does not allow mount namespaces, which the chroot needs."

exec 9>"$root.lock"
flock 9

if [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$wanted" ]; then
    exit 0
fi

mirror=$(apt-get indextargets --format '$(REPO_URI)' 2>/dev/null | sort -u | grep -E '/debian/?$' | head -n 1 || true)
[ -n "$mirror" ] || cannot "apt on this machine knows no Debian mirror; add one to its sources to test in real Blender."

if ! command -v debootstrap >/dev/null; then
    apt-get update -qq || true
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends debootstrap >/dev/null \
        || cannot "debootstrap could not be installed; install it to test in real Blender."
fi

# An unfinished base is started anew: debootstrap cannot go on where it stopped.
if [ ! -f "$root/.boxmorph-base" ]; then
    rm -rf "$root"
    debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$log" 2>&1 \
        || { echo "provision_blender: debootstrap failed; see $log" >&2; exit 1; }
    touch "$root/.boxmorph-base"
fi
cp /etc/resolv.conf "$root/etc/resolv.conf"
ln -sf /proc/self/mounts "$root/etc/mtab"

# Snapshots of sid on a mirror outlive their "Valid-Until" date.
"$here/enter_chroot.sh" "$root" sh -c "
    set -e
    export DEBIAN_FRONTEND=noninteractive
    apt-get -o Acquire::Check-Valid-Until=false update
    apt-get install -y --no-install-recommends $wanted
    apt-get clean
    blender -b --version" >>"$log" 2>&1 \
    || { echo "provision_blender: installing Blender failed; see $log" >&2; exit 1; }
echo "$wanted" >"$stamp"
