# Writes OUT, the source that tells the commit of the tree at SOURCE; leaves it alone where nothing changed, so that
# a build without a new commit compiles and links nothing. Called at every build.
find_program(GIT git)
set(commit "")
if(GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=7 HEAD
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT} -C ${SOURCE} diff --quiet HEAD RESULT_VARIABLE changed ERROR_QUIET)
  if(commit AND changed)
    string(APPEND commit ", changed")
  endif()
endif()
set(text "#include \"server/commit.hpp\"\n\nnamespace floeplan::server {\n\nconst char* commit() { return \"${commit}\"; }\n\n}  // namespace floeplan::server\n")
file(CONFIGURE OUTPUT ${OUT} CONTENT "${text}" @ONLY)
