# Compiler, linker and warnings. Our code is built with warnings as errors; generated code is not ours.
option(FOOTHOLD_WERROR "Warnings are errors in our code" ON)
set(FOOTHOLD_SANITIZE "" CACHE STRING "Sanitizers for everything, as in -fsanitize=")

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
find_program(MOLD mold)
if(MOLD)
  add_link_options(-fuse-ld=mold)
endif()

# The same plan on every machine: no fused multiply-add behind our back.
add_compile_options(-ffp-contract=off -fno-math-errno)
if(FOOTHOLD_SANITIZE)
  add_compile_options(-fsanitize=${FOOTHOLD_SANITIZE} -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${FOOTHOLD_SANITIZE})
  add_compile_definitions(FOOTHOLD_SANITIZED=1)
  if(NOT FOOTHOLD_FUZZ)  # with the checks in, -O2 takes twice as long to compile as -O1 and saves little at run time
    add_compile_options(-O1)
  endif()
  if(FOOTHOLD_FUZZ)  # all of our code tells the fuzzer where it has been
    add_compile_options(-fsanitize=fuzzer-no-link)
    add_link_options(-fsanitize=fuzzer-no-link)
  endif()
  if(FOOTHOLD_SANITIZE MATCHES thread)
    # Asio uses fences, which the sanitizer does not know; what they guard is also under locks.
    add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-tsan>)
  endif()
endif()

# foothold_ours(target): the warnings that our own code must be free of. Not errors under the sanitizers: gcc then warns of what is sound.
# -Wrestrict: gcc 12 sees overlaps in string + string that are not there.
function(foothold_ours target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-missing-field-initializers>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>)
  if(FOOTHOLD_WERROR AND NOT FOOTHOLD_SANITIZE)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
  endif()
endfunction()
