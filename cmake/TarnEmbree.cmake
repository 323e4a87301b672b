# The target tarn_embree: Embree 3 (Debian 12, Ubuntu 22.04) or 4 (Ubuntu 24.04), and oneTBB. Their calls differ a little;
# src/reference/embree.h knows it.

find_package(TBB REQUIRED)
find_path(EMBREE_INCLUDE_DIR NAMES embree4/rtcore.h embree3/rtcore.h REQUIRED)
find_library(EMBREE_LIBRARY NAMES embree4 embree3 REQUIRED)
add_library(tarn_embree INTERFACE)
target_include_directories(tarn_embree SYSTEM INTERFACE ${EMBREE_INCLUDE_DIR})
target_link_libraries(tarn_embree INTERFACE ${EMBREE_LIBRARY} TBB::tbb)
