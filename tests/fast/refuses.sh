#!/bin/sh
# refuses.sh TESTS: passes if the test program TESTS starts, runs, and some test fails.
out=$(GTEST_FAIL_FAST=1 "$1" 2>&1)
status=$?
echo "$out" | grep -E '^\[  (FAILED|PASSED)' | tail -n 5
[ "$status" -eq 1 ] && echo "$out" | grep -q '^\[  FAILED  \]'
