# What makes a fault of memory harder to use, in every program but those of the tests, which see no foreign bytes. None of it
# changes what is computed: plans stay the same to the last bit. tests/architecture reads the built program and names what
# is missing.
set(hardened $<NOT:$<BOOL:$<TARGET_PROPERTY:FLOEPLAN_IS_TEST>>>)

target_compile_options(floeplan_options INTERFACE
  $<${hardened}:-fPIE;-fstack-clash-protection;-fstack-protector-strong>
  # In force once all that is linked in is built so, too, and the kernel does its part.
  $<$<AND:${hardened},$<STREQUAL:${CMAKE_SYSTEM_PROCESSOR},x86_64>>:-fcf-protection>)
# Calls that know how large their target is check it. It needs an optimiser, and the sanitizers look at the calls themselves.
if(NOT FLOEPLAN_SANITIZE AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  target_compile_options(floeplan_options INTERFACE $<${hardened}:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=3>)
endif()
# The program lies at another address each time, and what the loader fills in is read-only from then on.
add_link_options(-pie -Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
