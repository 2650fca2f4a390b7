# Runs PROGRAM under VALGRIND's callgrind in WORK and prints the instructions of each operation, and
# the ratio of the generic code to instructions written by hand.
set(output ${WORK}/instruction_counts.callgrind)
execute_process(COMMAND ${VALGRIND} --tool=callgrind --callgrind-out-file=${output} ${PROGRAM}
                RESULT_VARIABLE failed ERROR_VARIABLE messages)
if(failed)
  message(FATAL_ERROR "${messages}")
endif()
execute_process(COMMAND ${CALLGRIND_ANNOTATE} --inclusive=yes --threshold=100 ${output} OUTPUT_VARIABLE report)

# The instructions of a thousand calls of a function, those that it calls included.
function(count function result)
  if(NOT report MATCHES "\n *([0-9,]+) [^\n]*[: ]${function}\\(")
    message(FATAL_ERROR "callgrind knows no ${function}()")
  endif()
  string(REPLACE "," "" instructions ${CMAKE_MATCH_1})
  math(EXPR instructions "(${instructions} + 500) / 1000")
  set(${result} ${instructions} PARENT_SCOPE)
endfunction()

function(compare what generic by_hand)
  count(${generic} x)
  count(${by_hand} y)
  math(EXPR percent "(100 * ${x} + ${y} / 2) / ${y}")
  message("${what}: ${x} instructions, ${y} by hand, ${percent} %")
endfunction()
compare("blend of two bicubic patches" surface_blend_generic surface_blend_by_hand)
if(report MATCHES "exact_surface_blend_generic")
  compare("the same, decimals p/1000" exact_surface_blend_generic exact_surface_blend_by_hand)
endif()
compare("jet of order 3, degree 5" jet_generic jet_by_hand)
compare("the same, prepared" prepared_jet_generic prepared_jet_by_hand)
compare("quintic blend" blend_generic blend_by_hand)
compare("quintic blend, to one by hand without checks" blend_generic blend_by_hand_unchecked)
