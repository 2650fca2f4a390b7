# Most tests are short: test/run has them. These take long: other kernels and examples than the most common, many optima and samples, proofs
# by Gappa, and the program under limits of time and memory or on many files, for which it is optimised. .ci/run has them, by g++; a build
# that is not asked to leave them out has both. The target long_tests builds what they need.
option(GEOMETRIC_CONTINUITY_SHORT_TESTS_ONLY "Leave out tests that take long, and the optimisation of the program" OFF)
set(long_tests
    # other kernels
    cases_double cases_epeck cases_epick test_kernel_archetype test_kernel_cpp_rational test_kernel_double test_kernel_epeck_d
    test_kernel_epick_d test_kernel_gmpq test_kernel_homogeneous
    # what computes much
    test_Edge_enclosure test_Fair test_Fair_kernels test_curve_from_curvatures test_decide_join test_largest_kink test_optimised_splines
    parallel_tests
    # proofs and other libraries
    edge_bounds join_bounds test_arb test_peers_of_rational_curves test_peers_of_rational_surfaces
    # the package in other projects, and with other packages
    install manual_in_cgal pipeline_aabb_tree pipeline_arrangement pipeline_bezier_arrangement pipeline_box_intersection
    pipeline_constrained_triangulation pipeline_polyline_simplification pipeline_surface_mesh
    # the program
    program_big program_cad program_cad_reader program_cad_report program_cad_verdicts program_certificates program_drawings program_manual
    program_manual_numbers program_memory program_output program_report_in_browser program_words program_work manual
    # inputs that searches have found
    fuzz_certificates fuzz_curves fuzz_drawings fuzz_fonts fuzz_numbers fuzz_paths fuzz_repairs fuzz_surfaces fuzz_variable_fonts)
add_custom_target(long_tests)

# label_long(TEST [TARGET...]): after add_test, for the tests that are listed above. The test needs the targets.
function(label_long test)
  if(NOT test IN_LIST long_tests)
    return()
  endif()
  set_tests_properties(${test} PROPERTIES LABELS long DISABLED ${GEOMETRIC_CONTINUITY_SHORT_TESTS_ONLY})
  if(ARGN)
    add_dependencies(long_tests ${ARGN})
    set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ${GEOMETRIC_CONTINUITY_SHORT_TESTS_ONLY})
  endif()
endfunction()
