# What the package needs, at its own build and in the projects that use it.
# Sets SMD_MISSING_DEPENDENCY to a message if something that it cannot do without is missing.
set(SMD_MISSING_DEPENDENCY "")
find_package(CGAL QUIET)
find_package(Eigen3 3.3.7 CONFIG QUIET)
find_package(TBB CONFIG QUIET)
if(NOT CGAL_FOUND OR CGAL_VERSION VERSION_LESS 5.5)
  set(SMD_MISSING_DEPENDENCY "Surface_mesh_denoising needs CGAL 5.5 or later (found: ${CGAL_VERSION})")
elseif(NOT Eigen3_FOUND)
  set(SMD_MISSING_DEPENDENCY "Surface_mesh_denoising needs Eigen 3.3.7 or later")
else()
  include(${CGAL_MODULES_DIR}/CGAL_Eigen3_support.cmake)
  include(${CGAL_MODULES_DIR}/CGAL_TBB_support.cmake)
endif()
