# Most tests are short: test/run has them. A build that is not asked to leave the others out has
# all; .ci/run has them in two builds. A test case with the label "long" is left out of a test that
# is short otherwise. The target long_tests builds what the long ones need: other kernels and
# examples than the most common, many optima and samples, proofs by Gappa. The target release_tests
# builds the program as it is released, with optimisation, and what its tests need, under limits of
# time and memory or on many files; the exact cases on one kernel, and what optimisation could
# break, belong to it.
option(GEOMETRIC_CONTINUITY_SHORT_TESTS_ONLY "Leave out tests that take long" OFF)
option(GEOMETRIC_CONTINUITY_UNOPTIMISED_PROGRAM "Leave out the optimisation of the program, and the tests of what is released"
       ${GEOMETRIC_CONTINUITY_SHORT_TESTS_ONLY})
set(long_tests
    # other kernels
    cases_double cases_epeck test_kernel_archetype test_kernel_cpp_rational test_kernel_double test_kernel_epeck_d test_kernel_epick_d test_kernel_gmpq
    test_kernel_homogeneous
    # what computes much
    conformance_alterations conformance_checked conformance_generated test_Edge_enclosure test_Fair test_Fair_kernels test_curve_from_curvatures test_decide_join test_largest_kink parallel_tests
    # proofs and other libraries
    edge_bounds join_bounds test_arb test_peers_of_rational_curves test_peers_of_rational_surfaces
    # many files
    python_dask
    # other packages
    pipeline_aabb_tree pipeline_arrangement pipeline_bezier_arrangement pipeline_box_intersection pipeline_constrained_triangulation
    pipeline_polyline_simplification pipeline_surface_mesh
    # another platform
    browser_compiled browser_package
    # the pages of the manual, with links to the page that browser_package makes
    manual manual_blocks manual_in_cgal
    # inputs that searches have found
    fuzz_certificates fuzz_curves fuzz_drawings fuzz_fonts fuzz_numbers fuzz_paths fuzz_repairs fuzz_surfaces fuzz_variable_fonts)
set(release_tests
    cases_epick test_optimised_splines
    # the package in other projects, and what is packed
    install packaging_deb
    # the program
    program_big program_cad program_cad_losses program_cad_poles program_cad_reader program_cad_report program_cad_verdicts program_certificates program_drawings program_manual
    program_manual_numbers program_memory program_output program_report_in_browser program_wires program_words program_work)
add_custom_target(long_tests)
add_custom_target(release_tests)

# label_long(TEST [TARGET...]): after add_test, for the tests that are listed above. The test needs
# the targets.
function(label_long test)
  set(left_out ${GEOMETRIC_CONTINUITY_SHORT_TESTS_ONLY})
  if(test IN_LIST long_tests)
    set(label long)
  elseif(test IN_LIST release_tests)
    set(label release)
    if(GEOMETRIC_CONTINUITY_UNOPTIMISED_PROGRAM)
      set(left_out ON)
    endif()
  else()
    return()
  endif()
  set_tests_properties(${test} PROPERTIES LABELS ${label} DISABLED ${left_out})
  if(ARGN)
    add_dependencies(${label}_tests ${ARGN})
    set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ${left_out})
  endif()
endfunction()
