# The Debian packages, `cpack -G DEB` in the build folder: libaxiscert0 and libaxiscert-dev, as Debian divides a library, and
# from a whole build axiscert, the command. ./dev package makes and tries them. CPack has one line of summary for all packages:
# that of the command is given with -D there.
set(CPACK_PACKAGE_NAME axiscert)
set(CPACK_PACKAGE_VENDOR axiscert)
set(CPACK_PACKAGE_CONTACT "the authors of axiscert <axiscert@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL runtime development)

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact test of a sphere against a triangle, in SIMD")
set(how "It is built to answer as exact arithmetic on the numbers as given does, for\nevery finite input in binary32 and binary64.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libaxiscert0)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_MULTIARCH same)
configure_file(cmake/debian/shlibs.in ${PROJECT_BINARY_DIR}/debian/shlibs @ONLY)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/triggers
                                               ${PROJECT_BINARY_DIR}/debian/shlibs)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "${how}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libaxiscert-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libaxiscert0 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_MULTIARCH same)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${how}\nThis package has what building against it takes, for C and C++.")

# The command. Its plug-ins include <axiscert/plugin.h>, which is in libaxiscert-dev. Two components make one package: what
# `cmake --install` installs too, and what Debian wants in another place.
if(NOT AXISCERT_ONLY_LIBRARY)
  list(APPEND CPACK_COMPONENTS_ALL command command_debian)
  set(CPACK_COMPONENT_COMMAND_GROUP axiscert)
  set(CPACK_COMPONENT_COMMAND_DEBIAN_GROUP axiscert)
  set(CPACK_DEBIAN_AXISCERT_PACKAGE_NAME axiscert)
  set(CPACK_DEBIAN_AXISCERT_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_AXISCERT_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_AXISCERT_PACKAGE_DEPENDS "libaxiscert-dev (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_AXISCERT_PACKAGE_SUGGESTS "gcc, g++, cmake, libgmp-dev, gappa, coq, nodejs, python3-matplotlib")
  set(CPACK_DEBIAN_AXISCERT_DESCRIPTION "It runs a collision test on millions of random, adversarial and real queries,
and says where the test misses a contact, where it invents one, how deep, and
why. A test of your own is a shared object, or a program in any language.")
endif()

# The package for Python, which asks the command's for what comes with it.
if(TARGET axiscert_python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-axiscert)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "axiscert (= ${PROJECT_VERSION}), python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-tqdm, python3-torch, python3-matplotlib")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "A function of NumPy arrays or of tensors is judged beside exact arithmetic; queries,
exact answers and formulae in any format are arrays.")
endif()
include(CPack)
