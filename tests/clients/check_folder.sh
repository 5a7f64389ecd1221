#!/bin/bash
# Read everything in a published folder with programs that are not ours.
#
#   check_folder.sh FOLDER
#
# Archives are tested with unzip and opened beside themselves in a copy, where relative texture paths lead from one
# archive's files to another's. Then every .flt is read by osgconv and osgcheck, every .shp and .dbf by ogrinfo, every
# .rgb by iinfo, the record by openssl; with npm's packages on NODE_PATH every .glb by the Khronos validator and every .spz
# by splat-transform; with OpenUSD in ORB_PYTHON every .usdz under ARKit's rules. ORB_OSGCHECK: osgcheck where it is
# built already. Prints one line a file; exit code 1 if anything was not read.
set -euo pipefail
if [ $# -ne 1 ] || [ ! -d "$1" ]; then
    echo "usage: check_folder.sh FOLDER" >&2
    exit 2
fi
here=$(cd "$(dirname "$0")" && pwd)
folder=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$folder" "$work/copy"
mkdir "$work/empty"
failed=0
declare -A counts

# fail FILE READER LOG: say what was not read and what its reader said.
fail() {
    echo "FAILED  $2  $1"
    tail -n 20 "$3" | sed 's/^/        /'
    failed=$((failed + 1))
}

# each SUFFIX READER: run READER (a function of one path) on every such file of the copy.
each() {
    local path count=0
    while IFS= read -r -d '' path; do
        count=$((count + 1))
        if "$2" "$path" >"$work/log" 2>&1; then
            echo "ok      $2  ${path#"$work/copy/"}"
        else
            fail "${path#"$work/copy/"}" "$2" "$work/log"
        fi
    done < <(find "$work/copy" -type f -name "*.$1" -print0 | sort -z)
    echo "$2: .$1 files: $count"
    counts[$1]=$count
}

# at_once SUFFIX READER: as `each`, with READER a function of many paths that takes long to start. Where it finds fault with any,
# one after the other says with which.
at_once() {
    local paths path
    mapfile -d '' paths < <(find "$work/copy" -type f -name "*.$1" -print0 | sort -z)
    if [ ${#paths[@]} -eq 0 ] || ! "$2" "${paths[@]}" >"$work/log" 2>&1; then
        each "$1" "$2"
        return
    fi
    for path in "${paths[@]}"; do echo "ok      $2  ${path#"$work/copy/"}"; done
    echo "$2: .$1 files: ${#paths[@]}"
    counts[$1]=${#paths[@]}
}

archive() { unzip -tq "$1" && unzip -oq "$1" -d "$(dirname "$1")"; }

# osgconv answers 0 on broken files too: judge by what it says and writes.
osgconv_reads() {
    rm -f "$work/scene.osgt"
    (cd "$work/empty" && OSG_NOTIFY_LEVEL=INFO osgconv "$1" "$work/scene.osgt") >"$work/osgconv" 2>&1
    ! grep -E "an't find texture|read error|Unknown record" "$work/osgconv" && grep -q Geometry "$work/scene.osgt"
}

osgcheck_reads() { (cd "$work/empty" && "$osgcheck" "$1"); }

# So does ogrinfo. Coarse feature tiles of a store exist without features: the count may be 0.
ogrinfo_reads() {
    ogrinfo -al -so "$1" >"$work/ogrinfo" 2>&1
    cat "$work/ogrinfo"
    ! grep -q '^ERROR' "$work/ogrinfo" && grep -q '^Feature Count: [0-9]' "$work/ogrinfo"
}

iinfo_reads() { iinfo "$@" && ! iinfo --stats "$@" 2>&1 | grep -i error; }

gltf_reads() {
    local path paths=()
    for path in "$@"; do
        # The validator does not know the attributes of splats.
        case $path in *_splats.glb) ;; *) paths+=("$path") ;; esac
    done
    [ ${#paths[@]} -gt 0 ] || return 0
    node "$here/gltf_validate.cjs" "${paths[@]}" >"$work/gltf" 2>&1
    cat "$work/gltf"
    [ "$(grep -c 'errors 0 warnings 0 infos 0 hints 0' "$work/gltf")" -eq ${#paths[@]} ]
}

usd_reads() { "$ORB_PYTHON" "$here/usdz_check.py" "$1"; }

splats_read() { node "$splat_transform" -q -w "$1" "$work/back.ply" && head -c 3 "$work/back.ply" | grep -q ply; }

osgcheck=${ORB_OSGCHECK:-}
if [ -z "$osgcheck" ]; then
    osgcheck=$work/osgcheck
    g++ -O1 -o "$osgcheck" "$here/osgcheck.cpp" -losg -losgDB -losgViewer -losgUtil -losgGA -lOpenThreads
fi
each zip archive
each flt osgconv_reads
each flt osgcheck_reads
each shp ogrinfo_reads
each dbf ogrinfo_reads
at_once rgb iinfo_reads
if [ -n "${NODE_PATH:-}" ]; then
    splat_transform=$NODE_PATH/@playcanvas/splat-transform/bin/cli.mjs
    at_once glb gltf_reads
    each spz splats_read
fi
[ -z "${ORB_PYTHON:-}" ] || each usdz usd_reads

cd "$folder"
if openssl dgst -sha256 -verify orb-record.pub.pem -signature orb-record.sig orb-record.pae >"$work/log" 2>&1; then
    echo "ok      openssl  orb-record.sig over orb-record.pae"
else
    fail orb-record.sig openssl "$work/log"
fi
# The signed bytes must be the record's own: "DSSEv1", the type with its length, the payload with its length.
if python3 - >"$work/log" 2>&1 <<'PY'; then
import base64, json
record = json.load(open("orb-record.dsse.json"))
kind, payload = record["payloadType"].encode(), base64.b64decode(record["payload"])
assert b"DSSEv1 %d %s %d %s" % (len(kind), kind, len(payload), payload) == open("orb-record.pae", "rb").read()
assert base64.b64decode(record["signatures"][0]["sig"]) == open("orb-record.sig", "rb").read()
PY
    echo "ok      python3  orb-record.pae and orb-record.sig are the record's"
else
    fail orb-record.dsse.json python3 "$work/log"
fi

if [ "${counts[flt]}" -eq 0 ]; then
    echo "FAILED  there is no .flt in $folder"
    failed=$((failed + 1))
fi
if [ "$failed" -ne 0 ]; then
    echo "$failed not read"
    exit 1
fi
echo "everything read"
