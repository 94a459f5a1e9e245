# The libraries of the Windows program, cross-compiled from Debian's source packages; sourced by packaging/windows/build.
#
#   $cache/sources    source packages as Debian has them
#   $cache/work       unpacked sources and build folders, removed when a library is installed
#   $cache/prefix     what the program is built with
#   $cache/licences   copyright files of all parts, as Debian has them
#   $cache/done       one file a finished library, named after it

readonly cache=${FEEDSCOPE_WINDOWS_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/feedscope-windows}
readonly prefix=$cache/prefix
export FEEDSCOPE_WINDOWS_PREFIX=$prefix
readonly toolchain=$project_dir/packaging/windows/toolchain.cmake

# In the order in which they are built. Header files alone are copied from Debian's packages.
readonly core_libraries=(headers expat fmtlib cmark nlopt onetbb)
readonly picture_libraries=(double-conversion lz4 xz-utils libpng1.6 libjpeg-turbo tiff freetype glew pugixml qt6-base vtk9 qpdf)

# apt_sources get|cache ARGUMENT...: apt-get and apt-cache with source packages, without a change of the system's own lists.
apt_sources() {
  local tool=$1
  shift
  "apt-$tool" -q -o Dir::Etc::sourcelist="$cache/apt/sources.list" -o Dir::Etc::sourceparts=/dev/null -o Dir::State::lists="$cache/apt/lists" \
    -o Dir::Cache="$cache/apt/cache" -o APT::Sandbox::User=root "$@"
}

update_sources() {
  mkdir -p "$cache"/{sources,work,done,licences} "$cache"/apt/{lists,cache/archives}/partial "$prefix"
  [[ -e $cache/apt/updated ]] && return
  say 'Source packages: reading the lists'
  local codename signed='[signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]'
  codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
  cat >"$cache/apt/sources.list" <<LIST
deb-src $signed http://deb.debian.org/debian $codename main
deb-src $signed http://deb.debian.org/debian-security $codename-security main
LIST
  apt_sources get update || fail 'the lists of source packages cannot be read'
  touch "$cache/apt/updated"
}

# versions NAME: of its source packages, without epochs, newest first: of the security updates, of the release.
versions() {
  apt_sources cache --only-source showsrc "$1" 2>/dev/null | sed -n 's/^Version: //p' | sort -urV
}

# fetch NAME: the newest source package that the archive gives, checked by apt against Debian's signed list. Sets `dsc`;
# prints version and checksums.
fetch() {
  local name=$1 version
  while read -r version; do
    if (cd "$cache/sources" && apt_sources get source --download-only --only-source "$name=$version" >"$cache/work/$name.log" 2>&1); then
      dsc=$cache/sources/${name}_${version#*:}.dsc
      echo "   $name $version"
      awk '/^Checksums-Sha256:/ { on = 1; next } /^[^ ]/ { on = 0 } on { print "   sha256", $1, $3 }' "$dsc"
      return
    fi
    grep -h '^E: Failed to fetch' "$cache/work/$name.log" >&2 || true
  done < <(versions "$name")
  return 1
}

# cross NAME OPTION...: configures, builds and installs the unpacked package in $cache/work/NAME; folder `in`, if set, has
# its CMakeLists.txt.
cross() {
  local name=$1 log=$cache/work/$1.log
  shift
  cmake -G Ninja -S "$cache/work/$name/${in:-}" -B "$cache/work/$name-build" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_C_FLAGS_RELEASE='-O2 -DNDEBUG' -DCMAKE_CXX_FLAGS_RELEASE='-O2 -DNDEBUG' -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_INSTALL_LIBDIR:STRING=lib -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF "$@" >>"$log" 2>&1 &&
    ninja -C "$cache/work/$name-build" -j "${FEEDSCOPE_JOBS:-$(nproc)}" | tee -a "$log" | progress "$name" &&
    cmake --install "$cache/work/$name-build" --strip >>"$log" 2>&1
}

# Every tenth of what ninja does.
progress() {
  awk -v name="$1" 'match($0, /^\[[0-9]+\/[0-9]+\]/) { split(substr($0, 2, RLENGTH - 2), n, "/"); tenth = int(10 * n[1] / n[2]);
    if (tenth > last) { last = tenth; printf "   %s: %d of %d\n", name, n[1], n[2]; fflush() } } /FAILED|error:/ { print }'
}

# library NAME: fetches, builds and installs it unless it is done.
library() {
  local name=$1 start=$SECONDS in='' dsc=''
  if [[ -e $cache/done/$name ]]; then
    echo "   $name: done, $(<"$cache/done/$name")"
    return
  fi
  say "Library $name"
  if [[ $name != headers ]]; then
    fetch "$name" || fail "Debian's archive gives no source package $name"
    if [[ ! -d $cache/work/$name ]]; then
      dpkg-source -q --no-copy -x "$dsc" "$cache/work/$name.new" >>"$cache/work/$name.log" 2>&1 ||
        fail "$name cannot be unpacked; see $cache/work/$name.log"
      mv "$cache/work/$name.new" "$cache/work/$name"
    fi
  fi
  "build_${name//[.-]/_}" || {
    tail -n 30 "$cache/work/$name.log" >&2
    fail "$name could not be built; the whole output is in $cache/work/$name.log"
  }
  if [[ $name != headers ]]; then
    install -m 644 "$cache/work/$name/debian/copyright" "$cache/licences/$name.txt"
  fi
  echo "${dsc:+$(basename "${dsc%.dsc}"), }built in $((SECONDS - start)) s" >"$cache/done/$name"
  rm -rf "$cache/work/$name" "$cache/work/$name-build"
  echo "   built in $((SECONDS - start)) s"
}

# copy_package NAME PATTERN FOLDER: those files of an installed Debian package whose names match, from FOLDER into the prefix.
copy_package() {
  echo "   $1 $(dpkg-query -W -f '${Version}' "$1")"
  dpkg -L "$1" | grep -E "^$3/($2)" | sed "s|^$3/||" | tar -C "$3" -c --no-recursion -T - | tar -C "$prefix" -x &&
    install -m 644 "/usr/share/doc/$1/copyright" "$cache/licences/$1.txt"
}

# Header files, whose CMake files find them from where they are; that of toml++ names a library of Linux, so it gets
# another. zlib, which Debian has for MinGW. Licences of what the compiler adds to each program.
build_headers() {
  local package
  for package in libeigen3-dev nlohmann-json3-dev libcli11-dev libfast-float-dev libtomlplusplus-dev libutfcpp-dev; do
    copy_package $package 'include/|share/cmake/|share/eigen3/|lib/cmake/' /usr || return
  done
  mkdir -p "$prefix/lib/cmake/tomlplusplus"
  cat >"$prefix/lib/cmake/tomlplusplus/tomlplusplusConfig.cmake" <<'TOML'
if(NOT TARGET tomlplusplus::tomlplusplus)
  add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED)
  set_target_properties(tomlplusplus::tomlplusplus PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CMAKE_CURRENT_LIST_DIR}/../../../include")
endif()
TOML
  copy_package libz-mingw-w64-dev 'include/z.*\.h|lib/libz\.a' /usr/x86_64-w64-mingw32 || return
  for package in gcc-mingw-w64-base mingw-w64-x86-64-dev; do
    install -m 644 "/usr/share/doc/$package/copyright" "$cache/licences/$package.txt" || return
  done
}

build_expat() {
  # Debian's correction of a fault asks for the value, which CMake's template does not give.
  sed -i 's/^#cmakedefine XML_DTD$/#cmakedefine XML_DTD 1/' "$cache/work/expat/expat/expat_config.h.cmake"
  in=expat cross expat -DEXPAT_BUILD_TOOLS=OFF -DEXPAT_BUILD_EXAMPLES=OFF -DEXPAT_BUILD_TESTS=OFF -DEXPAT_BUILD_DOCS=OFF -DEXPAT_SHARED_LIBS=OFF
}
build_fmtlib() { cross fmtlib -DFMT_TEST=OFF -DFMT_DOC=OFF; }
build_cmark() { cross cmark -DCMARK_TESTS=OFF -DCMARK_SHARED=OFF -DCMARK_STATIC=ON; }
build_nlopt() { cross nlopt -DNLOPT_PYTHON=OFF -DNLOPT_OCTAVE=OFF -DNLOPT_MATLAB=OFF -DNLOPT_GUILE=OFF -DNLOPT_SWIG=OFF -DNLOPT_TESTS=OFF; }
build_onetbb() { cross onetbb -DTBB_TEST=OFF -DTBBMALLOC_BUILD=OFF -DTBB_STRICT=OFF; }

# Static, as the rest; zlib, PNG, JPEG, FreeType and double-conversion are those of the prefix, which VTK has too.
build_qt6_base() {
  local name feature=()
  for name in sql network dbus testlib xml icu fontconfig glib system_harfbuzz system_pcre2 zstd tabletevent vulkan direct2d; do
    feature+=("-DFEATURE_$name=OFF")
  done
  for name in zlib png jpeg freetype doubleconversion; do
    feature+=("-DFEATURE_system_$name=ON")
  done
  cross qt6-base -DQT_HOST_PATH=/usr -DQT_HOST_PATH_CMAKE_DIR=/usr/lib/x86_64-linux-gnu/cmake -DQT_QMAKE_TARGET_MKSPEC=win32-g++ \
    -DQT_BUILD_TESTS=OFF -DQT_BUILD_EXAMPLES=OFF -DINPUT_opengl=desktop -DFEATURE_pkg_config=OFF "${feature[@]}"
}

build_double_conversion() { cross double-conversion; }
build_lz4() { in=build/cmake cross lz4 -DLZ4_BUILD_CLI=OFF -DLZ4_BUILD_LEGACY_LZ4C=OFF -DBUILD_STATIC_LIBS=ON; }
build_xz_utils() { cross xz-utils; }
build_libpng1_6() { cross libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF; }
build_libjpeg_turbo() { cross libjpeg-turbo -DENABLE_SHARED=OFF -DWITH_TURBOJPEG=OFF -DWITH_SIMD=OFF; }
build_tiff() { cross tiff -Dtiff-tools=OFF -Dtiff-tests=OFF -Dtiff-contrib=OFF -Dtiff-docs=OFF -Dtiff-deprecated=OFF -Djbig=OFF -Dlerc=OFF -Dlzma=OFF -Dwebp=OFF -Dzstd=OFF -Dlibdeflate=OFF; }
build_freetype() { cross freetype -DFT_DISABLE_HARFBUZZ=ON -DFT_DISABLE_BROTLI=ON -DFT_DISABLE_BZIP2=ON; }
build_glew() { in=build/cmake cross glew -DBUILD_UTILS=OFF; }
build_pugixml() { cross pugixml; }
build_qpdf() { cross qpdf -DBUILD_STATIC_LIBS=ON -DREQUIRE_CRYPTO_NATIVE=ON -DUSE_IMPLICIT_CRYPTO=OFF -DBUILD_DOC=OFF; }

build_vtk9() {
  local module own=() enabled=()
  # What Debian has taken out of the source package comes from the libraries before.
  for module in doubleconversion eigen expat freetype glew jpeg lz4 lzma png pugixml tiff utf8 zlib; do
    own+=("-DVTK_MODULE_USE_EXTERNAL_VTK_$module=ON")
  done
  for module in CommonCore CommonDataModel CommonMath FiltersCore IOImage RenderingCore RenderingFreeType RenderingOpenGL2; do
    enabled+=("-DVTK_MODULE_ENABLE_VTK_$module=YES")
  done
  for module in Imaging MPI Qt Rendering StandAlone Views; do
    enabled+=("-DVTK_GROUP_ENABLE_$module=DONT_WANT")
  done
  cross vtk9 -DVTK_ENABLE_WRAPPING=OFF -DVTK_BUILD_TESTING=OFF -DVTK_BUILD_EXAMPLES=OFF -DVTK_BUILD_ALL_MODULES=OFF -DVTK_ENABLE_LOGGING=OFF \
    -DVTK_REQUIRE_LARGE_FILE_SUPPORT=1 -DVTK_ENABLE_REMOTE_MODULES=OFF -DVTK_SMP_IMPLEMENTATION_TYPE=Sequential -DVTK_INSTALL_SDK=ON "${own[@]}" "${enabled[@]}"
}
