# Tests of runs over MPI ranks.
find_package(MPI REQUIRED COMPONENTS C)
target_link_libraries(io_batch_tests MPI::MPI_C)
target_compile_definitions(io_batch_tests PRIVATE OMPI_SKIP_MPICXX)

# The same tests with several ranks. Open MPI must be configured to accept root and more ranks than cores.
add_test(NAME dispatch_over_ranks
  COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe -np 3 $<TARGET_FILE:io_batch_tests>
    --gtest_filter=Dispatch.*:Ranks.*:Run*)
foreach(ranks 2 3 5)
  add_test(NAME random_runs_over_${ranks}_ranks
    COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe -np ${ranks} $<TARGET_FILE:properties_tests>
      --gtest_filter=RunsOverRanks.*)
  list(APPEND over_ranks random_runs_over_${ranks}_ranks)
endforeach()
# Open MPI unloads modules without freeing their memory; such leaks have no symbol to suppress, so leak checks are off.
set_tests_properties(dispatch_over_ranks ${over_ranks} PROPERTIES
  ENVIRONMENT "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;LSAN_OPTIONS=detect_leaks=0")

# A rank that stops is named and ends the run. The tests check the message, not the exit code of mpirun.
foreach(test SilentRank.IsNamed SilentRank.ThatDealsIsNamed SilentRank.IsNamedWhereASumWaitsForIt)
  add_test(NAME ${test}
    COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe -np 2 $<TARGET_FILE:io_batch_tests> --gtest_filter=${test})
  set_tests_properties(${test} PROPERTIES
    ENVIRONMENT "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1" TIMEOUT 60
    PASS_REGULAR_EXPRESSION "rank [01] .process [0-9]+ on [^ ]+. sent no heartbeat for 1 s")
endforeach()
# A rank that is missing while MPI starts or ends cannot be named.
foreach(test SilentRank.ThatDoesNotComeIsNotWaitedFor SilentRank.ThatDoesNotComeToTheEndIsNotWaitedFor)
  add_test(NAME ${test}
    COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe -np 2 $<TARGET_FILE:io_batch_tests> --gtest_filter=${test})
  set_tests_properties(${test} PROPERTIES
    ENVIRONMENT "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1" TIMEOUT 60
    PASS_REGULAR_EXPRESSION "process [0-9]+ has waited 5 s for the other ranks to (start|end)")
endforeach()
