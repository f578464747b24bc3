#!/bin/sh
# ThreadSanitizer sees nothing of what Debian's libtbb synchronises and then calls every task a race. This builds the
# same version from Debian's source with ThreadSanitizer; the test preset `tsan` picks it up from there.
# Usage: tests/instrumented_tbb.sh [FOLDER, default build/tsan/tbb]
set -eu
mkdir -p "${1:-build/tsan/tbb}"
cd "${1:-build/tsan/tbb}"
mkdir -p lists/partial cache/archives/partial
here=$(pwd)
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
keys=/usr/share/keyrings/debian-archive-keyring.gpg
echo "deb-src [signed-by=$keys] http://deb.debian.org/debian $suite main" >source.list
apt() {
    apt-get -q -o Dir::Etc::SourceList="$here/source.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$here/lists" -o Dir::Cache="$here/cache" "$@"
}
apt update
apt source --download-only onetbb
tar -xf onetbb_*.orig.tar.* --strip-components=1 --one-top-level=source
cmake -S source -B build -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DTBB_TEST=OFF -DTBBMALLOC_BUILD=OFF \
    -DTBB_STRICT=OFF -DTBB_SANITIZE=thread -DTBB_OUTPUT_DIR_BASE=lib
cmake --build build
