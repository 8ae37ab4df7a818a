# What all our code is compiled with. Contraction would make results differ between processors.
include(CheckCXXSymbolExists)
option(LINK_BOUNDS_WERROR "treat warnings in our code as errors, as scripts/test does" OFF)
add_library(${PROJECT_NAME}_flags INTERFACE)
target_compile_features(${PROJECT_NAME}_flags INTERFACE cxx_std_17)
target_compile_options(${PROJECT_NAME}_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow $<$<BOOL:${LINK_BOUNDS_WERROR}>:-Werror>
  -ffp-contract=off)
# Headers inside the package are included by their path below src.
get_filename_component(src ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
target_include_directories(${PROJECT_NAME}_flags INTERFACE ${src})
# Eigen 3.3, of Debian 11 and Ubuntu 20.04, has no begin() and end(), which later ones have.
if(LINK_BOUNDS_WERROR)
  target_compile_definitions(${PROJECT_NAME}_flags INTERFACE
    EIGEN_MATRIXBASE_PLUGIN="geometry/as_eigen33.h" EIGEN_ARRAYBASE_PLUGIN="geometry/as_eigen33.h")
endif()
# Eigen contracts on its own where the compiler says that it can: for ARM, and for x86 from
# -march=haswell on.
target_compile_options(${PROJECT_NAME}_flags INTERFACE -U__ARM_FEATURE_FMA -U__FMA__)
# Eigen refuses AVX512 without. Its types stay aligned as in packages that use it.
check_cxx_symbol_exists(__AVX512F__ cstddef LINK_BOUNDS_AVX512)
if(LINK_BOUNDS_AVX512)
  target_compile_options(${PROJECT_NAME}_flags INTERFACE -U__AVX512F__)
  target_compile_definitions(${PROJECT_NAME}_flags INTERFACE
    EIGEN_MAX_ALIGN_BYTES=64 EIGEN_MAX_STATIC_ALIGN_BYTES=64)
endif()
