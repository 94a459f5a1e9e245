# cmake -DNPM=... -DFROM=... -DFOLDER=... -P NpmModules.cmake: the modules that FROM/package-lock.json pins, in FOLDER.
file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION ${FOLDER})
execute_process(
  COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
  WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "The libraries that ${FROM}/package-lock.json names could not be fetched from the npm registry; what npm "
    "says is above. The build needs it once: check the network and its proxy (npm config get registry, "
    "npm config get proxy) and build again.")
endif()
