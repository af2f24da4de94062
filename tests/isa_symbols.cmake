# Fails where two objects, compiled for different instruction sets, define one symbol that a linker would merge: it
# would keep one version for both, and a machine that lacks the better set would meet its instructions.
# cmake -D NM=nm -D A=one.o -D B=other.o [-D PATTERN=drapeau] -P isa_symbols.cmake
# PATTERN: only symbols that match it count.
cmake_minimum_required(VERSION 3.25)
foreach(object A B)
  # Weak, unique and global definitions; names stay mangled, which tell namespaces apart as well.
  execute_process(COMMAND ${NM} --defined-only ${${object}} OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]* [WVuTDBRGS] [^\n]*" lines "${listing}")
  set(${object}_symbols "")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[^ ]* [A-Za-z] " "" symbol "${line}")
    if(symbol MATCHES "${PATTERN}")
      list(APPEND ${object}_symbols ${symbol})
    endif()
  endforeach()
  list(LENGTH ${object}_symbols count)
  if(count EQUAL 0)
    message(FATAL_ERROR "${${object}} defines nothing that matches '${PATTERN}': the test looks at the wrong thing")
  endif()
endforeach()

set(shared "")
foreach(symbol IN LISTS A_symbols)
  if(symbol IN_LIST B_symbols)
    list(APPEND shared ${symbol})
  endif()
endforeach()
list(LENGTH shared count)
if(count GREATER 0)
  list(JOIN shared "\n  " names)
  message(FATAL_ERROR "${count} symbols are defined for both instruction sets:\n  ${names}")
endif()
