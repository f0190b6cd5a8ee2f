#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The whole of it in a house of one room: a test that asserts nothing notices nothing, and no mutant is tried twice."""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

MUTATE = pathlib.Path(sys.argv.pop()) / "mutate.py"

HOUSE = """cmake_minimum_required(VERSION 3.25)
project(Tiny LANGUAGES CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
include_directories(${PROJECT_SOURCE_DIR})
enable_testing()
add_library(tiny STATIC room/limit.cpp room/sum.cpp)
set_target_properties(tiny PROPERTIES UNITY_BUILD ON)
add_subdirectory(tests/room)
"""
TESTS = """add_executable(test_limit limit_test.cpp)
target_link_libraries(test_limit tiny)
add_test(NAME room.limit COMMAND ${PROJECT_SOURCE_DIR}/run_test $<TARGET_FILE:test_limit>)
"""
JOINED = """file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/test_room_0.cpp "#include \\"limit_test.cpp\\"\n#include \\"main.cpp\\"\n")
add_executable(test_room ${CMAKE_CURRENT_BINARY_DIR}/test_room_0.cpp)
target_include_directories(test_room PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(test_room tiny)
add_test(NAME room.limit COMMAND ${PROJECT_SOURCE_DIR}/run_test $<TARGET_FILE:test_room> limit_test)
"""
CHOOSES = """#include "room/limit.hpp"
#include <string>
int limit_test();
int main(int argc, char** argv) { return argc == 2 && argv[1] == std::string("limit_test") ? limit_test() : 2; }
"""
LIMIT = """#include "room/limit.hpp"
#include "room/sum.hpp"
double limited(double force) { return force > limit ? limit : sum(force, 0.0); }
"""
SHARP = """#include "room/limit.hpp"
int main() {
    return limited(2.0) == 1.5 && limited(1.5) == 1.5 && limited(1.0) == 1.0 && limited(-9.0) == -9.0 ? 0 : 1;
}
"""
BLUNT = """#include "room/limit.hpp"
int main() { limited(2.0); }
"""
SLOW = """#include <unistd.h>
int main() { usleep(300000); }
"""


class Run(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        self.write("CMakeLists.txt", HOUSE)
        self.write("tests/room/CMakeLists.txt", TESTS)
        self.write("tests/equivalent_mutants.txt", "")
        self.write("run_test", "#!/bin/sh\nexec \"$@\"\n").chmod(0o755)
        self.write("room/limit.cpp", LIMIT)
        self.write("room/limit.hpp", "#pragma once\ninline constexpr double limit = 1.5;\ndouble limited(double force);\n")
        self.write("room/sum.cpp", '#include "room/sum.hpp"\ndouble sum(double a, double b) { return a + b; }\n')
        self.write("room/sum.hpp", "#pragma once\ndouble sum(double a, double b);\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def build(self, test):
        self.write("tests/room/limit_test.cpp", test)
        build = self.root / "build/release"
        for command in (["cmake", "-G", "Ninja", "-S", self.root, "-B", build], ["cmake", "--build", build]):
            subprocess.run(command, check=True, capture_output=True)

    def mutate(self, *options, room="room", status=0):
        done = subprocess.run([sys.executable, MUTATE, "--root", self.root, room, *options], capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout

    def record(self):
        return (self.root / "build/mutants/room.jsonl").read_text(encoding="utf-8").splitlines()

    def counts(self, said):
        noticed, of = re.search(r"room: (\d+) of (\d+) mutants noticed", said).groups()
        return int(noticed), int(of)

    def test_a_sharp_test_notices_all_but_what_nobody_can(self):
        self.build(SHARP)
        said = self.mutate()
        noticed, of = self.counts(said)
        self.assertGreaterEqual(of, 8)
        self.assertEqual(noticed, of - 2, said)  # at the limit both sides are the same; and 0 is added
        for line in ("+ double limited(double force) { return force >= limit ? limit : sum(force, 0.0); }",
                     "+ double sum(double a, double b) { return a - b; }"):
            self.assertIn(line, said)

    def test_of_what_goes_wrong_at_random_200_are_tried_unless_a_person_says_more(self):
        self.build("#include <cstdlib>\n#include <string>\n" +
                   SHARP.replace("return ", 'return std::getenv("TP_SCHEDULES") != std::string("200") || '))
        noticed, of = self.counts(self.mutate())
        self.assertEqual(noticed, of - 2)
        shutil.rmtree(self.root / "build/mutants")
        with unittest.mock.patch.dict("os.environ", TP_SCHEDULES="2000"):
            self.assertEqual(self.counts(self.mutate()), (0, of))

    def test_of_a_program_of_many_tests_the_named_one_is_run(self):
        self.write("tests/room/CMakeLists.txt", JOINED)
        self.write("tests/room/main.cpp", CHOOSES)
        self.build(SHARP.replace("int main()", "int limit_test()"))
        noticed, of = self.counts(self.mutate())
        self.assertEqual(noticed, of - 2)
        self.assertEqual(self.counts(self.mutate("--file", "limit.hpp")), (2, 2))

    def test_a_header_is_mutated_where_it_is_included(self):
        self.build(SHARP)
        self.assertEqual(self.counts(self.mutate("--file", "limit.hpp")), (2, 2))
        self.build(BLUNT)
        self.assertEqual(len(self.record()), 2)

    def test_what_a_blunt_test_does_not_notice_is_shown_and_tried_again_by_a_sharp_one(self):
        self.build(BLUNT)
        noticed, of = self.counts(self.mutate("--jobs", "2"))
        self.assertEqual(noticed, 0)
        self.assertEqual(self.counts(self.mutate("--at-least", "75")), (0, of))  # too few to say anything
        self.assertEqual(len(self.record()), len(set(self.record())))
        tried = len(self.record())
        self.mutate()
        self.assertEqual(len(self.record()), tried)
        self.build(SHARP)
        self.assertEqual(self.counts(self.mutate()), (of - 2, of))

    def test_an_interrupted_run_ends_at_once_and_the_next_goes_on(self):
        self.build(SLOW)
        command = [sys.executable, MUTATE, "--root", self.root, "room", "--jobs", "2"]
        running = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        record = self.root / "build/mutants/room.jsonl"
        while not record.exists() and running.poll() is None:
            time.sleep(0.05)
        running.send_signal(signal.SIGINT)
        said, _ = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 130)
        self.assertIn("not tried", said)
        self.assertIn("goes on from here", said)
        tried = self.record()
        self.mutate("--jobs", "2")
        self.assertEqual(self.record()[:len(tried)], tried)
        self.assertNotIn("not tried", self.mutate())

    def test_a_sample_is_the_same_for_the_same_seed(self):
        self.build(BLUNT)
        chosen = self.mutate("--list", "--sample", "4", "--seed", "a")
        self.assertEqual(chosen, self.mutate("--list", "--sample", "4", "--seed", "a"))
        self.assertEqual(chosen.count("room/"), 4)
        self.assertNotEqual(chosen, self.mutate("--list", "--sample", "4", "--seed", "b"))

    def test_a_rooms_goal_is_told_and_a_sample_of_each_room_is_taken(self):
        self.build(BLUNT)
        self.write("packaging/mutation/rooms.txt", "# room, goal\nroom 92\n")
        command = [sys.executable, MUTATE, "--root", self.root]
        said = subprocess.run([*command, "--each", "4"], capture_output=True, text=True, check=True).stdout
        self.assertIn("room: 0 of 4 mutants noticed, 0.0 % (goal 92 %, not met)", said)
        self.assertEqual(len(self.record()), 4)
        said = subprocess.run([*command, "--quick"], capture_output=True, text=True, check=True).stdout
        self.assertIn("There is no mutant.", said)
        self.write("packaging/mutation/rooms.txt", "room 92 quick\n")
        self.build(SHARP)
        said = subprocess.run([*command, "--quick", "--file", "limit.hpp"], capture_output=True, text=True, check=True).stdout
        self.assertIn("room: 2 of 2 mutants noticed, 100.0 % (goal 92 %)", said)

    def test_a_listed_equivalent_does_not_count_and_a_stale_one_is_told(self):
        self.build(BLUNT)
        _, of = self.counts(self.mutate())
        self.write("tests/equivalent_mutants.txt", "room/sum.cpp\n- double sum(double a, double b) { return a + b; }\n"
                   "+ double sum(double a, double b) { return a - b; }\nNothing but 0 is added.\n\n"
                   "room/sum.cpp\n- gone\n+ away\nIt was there once.\n")
        said = self.mutate()
        self.assertEqual(self.counts(said), (0, of - 1))
        self.assertIn("1 listed as equivalent", said)
        self.assertIn("no such mutant any more", said)

    def test_a_room_within_a_room_is_tried_with_the_tests_around_it(self):
        self.write("CMakeLists.txt", HOUSE.replace("room/sum.cpp", "room/sum.cpp room/inner/twice.cpp"))
        self.write("room/inner/twice.cpp", "double twice(double force) { return force + force; }\n")
        self.build("double twice(double);\nint main() { return twice(3.0) == 6.0 ? 0 : 1; }\n")
        self.assertIn("room/inner: 2 of 2 mutants noticed", self.mutate(room="room/inner"))

    def test_a_test_that_does_without_the_room_s_library_is_linked_without_it(self):
        """And without what the room needs."""
        self.write("CMakeLists.txt", HOUSE.replace("add_subdirectory", "add_library(base STATIC base.cpp)\nadd_subdirectory"))
        self.write("base.cpp", "double base() { return 1.0; }\n")
        self.write("room/sum.cpp", "double base();\ndouble sum(double a, double b) { return a + b * base(); }\n")
        self.write("room/alone.cpp", "double alone() { return 2.0; }\n")
        self.write("CMakeLists.txt", (self.root / "CMakeLists.txt").read_text().replace(
            "add_subdirectory", "add_library(alone STATIC room/alone.cpp)\ntarget_link_libraries(tiny base)\nadd_subdirectory"))
        self.write("tests/room/CMakeLists.txt", TESTS + TESTS.replace("limit", "alone").replace("tiny", "alone"))
        self.write("tests/room/alone_test.cpp", "double alone();\nint main() { return alone() == 2.0 ? 0 : 1; }\n")
        self.build(SHARP)
        self.assertIn("alone() { return 2.0; }", self.mutate("--file", "alone.cpp", "--list"))
        noticed, of = self.counts(self.mutate("--file", "alone.cpp"))
        self.assertEqual(noticed, of)

    def test_a_program_beside_the_test_is_found_there(self):
        self.build("""#include "room/limit.hpp"
#include <filesystem>
int main() {
    const auto beside = std::filesystem::canonical("/proc/self/exe").parent_path() / "helper";
    return std::filesystem::exists(beside) && limited(2.0) == 1.5 ? 0 : 1;
}
""")
        shutil.copy("/bin/true", self.root / "build/release/tests/room/helper")
        self.assertGreater(self.counts(self.mutate("--sample", "4"))[1], 0)

    def test_one_that_goes_round_and_round_is_noticed(self):
        self.write("room/sum.cpp", """double sum(double a, double b) {
    volatile double left = 1.0;
    while (left > 0.0)
        left = left - 1.0;
    return a + b;
}
""")
        self.build(BLUNT.replace("2.0", "1.0"))
        said = self.mutate("--file", "sum.cpp")
        self.assertEqual(self.counts(said)[0], 2, said)
        self.assertNotIn("left = left + 1.0;", said)

    def test_the_tests_write_into_memory_where_there_is_room(self):
        memory = pathlib.Path("/dev/shm")
        if not memory.is_dir() or shutil.disk_usage(memory).free < 5 << 30 or os.statvfs(memory).f_flag & os.ST_NOEXEC:
            self.skipTest("there is no such memory here")
        self.build("""#include "room/limit.hpp"
#include <cstdlib>
#include <string>
int main() { return std::string(std::getenv("TMPDIR")).rfind("/dev/shm/", 0) == 0 && limited(2.0) == 1.5 ? 0 : 1; }
""")
        self.assertGreater(self.counts(self.mutate("--sample", "4"))[1], 0)

    def test_a_terminal_that_a_test_opens_is_not_its_own(self):
        """Or closing it would hang up on the test."""
        self.build("""#include "room/limit.hpp"
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>
int main() {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (grantpt(terminal) != 0 || unlockpt(terminal) != 0 || open(ptsname(terminal), O_RDWR) < 0)
        return 1;
    close(terminal);
    return limited(2.0) == 1.5 ? 0 : 1;
}
""")
        self.assertGreater(self.counts(self.mutate("--sample", "4"))[1], 0)

    def test_tests_that_fail_by_themselves_are_told(self):
        self.build("int main() { return 1; }\n")
        done = subprocess.run([sys.executable, MUTATE, "--root", self.root, "room"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("room.limit fails without any mutant", done.stderr)

    def test_only_what_changed_is_tried(self):
        def git(*words):
            subprocess.run(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b", *words], check=True,
                           capture_output=True)
        self.build(BLUNT)
        git("init", "-q")
        git("add", "room")
        git("commit", "-qm", "one")
        self.assertIn("Nothing changed", self.mutate("--changed-since", "HEAD"))
        self.write("room/sum.cpp", '#include "room/sum.hpp"\ndouble sum(double a, double b) { return b + a; }\n')
        said = self.mutate("--changed-since", "HEAD", "--list")
        self.assertIn("room/sum.cpp", said)
        self.assertNotIn("room/limit.cpp", said)


if __name__ == "__main__":
    unittest.main()
