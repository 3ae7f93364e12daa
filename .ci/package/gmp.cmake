# GMP and MPFR as imported targets: suture::gmpxx, suture::gmp and suture::mpfr. The build and the
# installed package both include this file.
foreach(suture_library gmpxx gmp mpfr)
  if(NOT TARGET suture::${suture_library})
    find_library(SUTURE_${suture_library}_LIBRARY ${suture_library} REQUIRED)
    mark_as_advanced(SUTURE_${suture_library}_LIBRARY)
    add_library(suture::${suture_library} UNKNOWN IMPORTED GLOBAL)
    set_target_properties(suture::${suture_library} PROPERTIES
      IMPORTED_LOCATION "${SUTURE_${suture_library}_LIBRARY}")
  endif()
endforeach()
