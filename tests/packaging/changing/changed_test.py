#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What packaging/changing tells of a tiny house: which of its programs a change is in, and whose turn it is."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHANGING = pathlib.Path(sys.argv.pop())
sys.path.insert(0, str(CHANGING))

from changed import changed_files, changed_programs, changed_tests, left_out, run_by, third_of, unreached  # noqa: E402
from made_of import MadeOf  # noqa: E402

NINJA = """\
rule CXX_COMPILER__room
  command = cp $in $out && printf '%s: %s %s\\n' $out $in $HEADERS > $out.d
  deps = gcc
  depfile = $out.d
rule CXX_STATIC_LIBRARY_LINKER__room
  command = cat $in > $out
rule CXX_EXECUTABLE_LINKER__program
  command = cat $in > $out
build room.o: CXX_COMPILER__room ../room/room.cpp
  HEADERS = links/room.hpp
build room.a: CXX_STATIC_LIBRARY_LINKER__room room.o
build a$ test.o: CXX_COMPILER__room ../tests/room/a_test.cpp
build helper.o: CXX_COMPILER__room ../helper/main.cpp
build helper: CXX_EXECUTABLE_LINKER__program helper.o
build tests/a: CXX_EXECUTABLE_LINKER__program a$ test.o | room.a || helper
build tests/b: CXX_EXECUTABLE_LINKER__program helper.o
"""


class Changed(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name).resolve()
        for name in ("room/room.cpp", "room/room.hpp", "tests/room/a_test.cpp", "helper/main.cpp"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(f"// {name}\n", encoding="utf-8")
        (self.root / "build/links").mkdir(parents=True)
        (self.root / "build/links/room.hpp").symlink_to(self.root / "room/room.hpp")
        (self.root / "build/build.ninja").write_text(NINJA, encoding="utf-8")
        subprocess.run(["ninja", "-C", self.root / "build"], check=True, capture_output=True)
        made_of = MadeOf(self.root, self.root / "build")
        self.sources = {program: made_of.sources(program) for program in made_of.programs}

    def test_a_program_is_made_of_sources_headers_and_the_programs_that_it_runs(self):
        self.assertEqual({"helper": {"helper/main.cpp"}, "tests/b": {"helper/main.cpp"},
                          "tests/a": {"room/room.cpp", "room/room.hpp", "tests/room/a_test.cpp", "helper/main.cpp"}}, self.sources)

    def test_a_header_changes_those_that_include_it(self):
        self.assertEqual({"tests/a"}, changed_programs(self.sources, {"room/room.hpp"}))
        self.assertEqual({"helper", "tests/a", "tests/b"}, changed_programs(self.sources, {"helper/main.cpp"}))
        self.assertEqual(set(), changed_programs(self.sources, {"room/for_windows.cpp"}))

    def test_data_count_for_the_programs_in_the_next_folder_above(self):
        self.assertEqual({"tests/a"}, changed_programs(self.sources, {"tests/room/corpus/deep/one"}))
        self.assertEqual({"tests/a"}, changed_programs(self.sources, {"room/CMakeLists.txt"}))
        self.assertEqual(set(self.sources), changed_programs(self.sources, {"resources/samples/anna.jpg"}))
        self.assertEqual(set(self.sources), changed_programs(self.sources, {"CMakeLists.txt"}))

    def test_what_is_compiled_and_read_as_well_counts_as_data(self):
        sources = {"a": {"room/room.cpp", "resources/anna.jpg"}, "b": {"helper/main.cpp"}}
        self.assertEqual({"a", "b"}, changed_programs(sources, {"resources/anna.jpg"}))

    def test_a_build_that_was_never_begun_names_its_programs(self):
        for left in (".ninja_deps", ".ninja_log"):
            (self.root / "build" / left).unlink()
        self.assertEqual({"helper", "tests/a", "tests/b"}, set(MadeOf(self.root, self.root / "build").programs))

    def test_prose_and_scripts_change_no_program(self):
        self.assertEqual(set(), changed_programs(self.sources, {"room/README.md", "packaging/test", "tests/e2e/run_headless"}))

    def test_changes_are_those_since_a_commit_those_of_today_and_those_that_went(self):
        def git(*words):
            subprocess.run(["git", "-C", self.root, "-c", "user.name=A", "-c", "user.email=a@example.org", *words], check=True)
        git("init", "-q")
        git("add", "room", "helper")
        git("commit", "-qm", "one")
        (self.root / "room/room.cpp").write_text("int room;\n", encoding="utf-8")
        (self.root / "helper/main.cpp").unlink()
        self.assertEqual({"room/room.cpp", "helper/main.cpp"}, changed_files(self.root, "HEAD"))


class Own(unittest.TestCase):
    sources = {
        "tests/core/servo/test_loop": {"core/servo/loop.cpp", "core/base/result.hpp", "tests/core/servo/loop_test.cpp",
                                       "tests/core/servo/bench.hpp", "tests/support/doubles.hpp"},
        "tests/core/servo/deep/test_drawn": {"core/servo/loop.cpp", "tests/core/servo/deep/drawn_test.cpp",
                                             "tests/core/servo/bench.hpp"},
        "tests/app/test_page": {"app/page.cpp", "core/servo/loop.cpp", "tests/app/page_test.cpp", "tests/support/doubles.hpp"},
        "bin/touchphoto": {"app/page.cpp", "core/servo/loop.cpp"},
    }

    def own(self, *changes):
        return changed_tests(self.sources, set(changes))

    def test_a_room_s_own_tests_and_programs_are_changed_by_it_and_no_others(self):
        self.assertEqual({"tests/core/servo/test_loop", "bin/touchphoto"}, self.own("core/servo/loop.cpp"))
        self.assertEqual({"tests/app/test_page", "bin/touchphoto"}, self.own("app/page.cpp"))

    def test_a_test_is_changed_by_what_lies_beside_and_above_it(self):
        self.assertEqual({"tests/core/servo/test_loop"}, self.own("tests/core/servo/loop_test.cpp"))
        self.assertEqual({"tests/core/servo/test_loop", "tests/core/servo/deep/test_drawn"}, self.own("tests/core/servo/bench.hpp"))
        self.assertEqual({"tests/core/servo/test_loop"}, self.own("tests/core/servo/samples/a.csv"))

    def test_what_all_are_made_of_waits_for_its_turn(self):
        self.assertEqual(set(), self.own("tests/support/doubles.hpp"))
        self.assertEqual(set(), self.own("core/base/result.hpp"))


class Turns(unittest.TestCase):
    tests = {f"room.{number}": ["run_test", f"tests/{number}"] for number in range(60)}
    programs = {f"tests/{number}" for number in range(60)}

    def test_each_has_its_turn_in_every_three(self):
        for start in (0, 7, 812):
            out = [set(left_out(self.tests, self.programs, set(), turn)) for turn in range(start, start + 3)]
            for name in self.tests:
                self.assertEqual(2, sum(name in left for left in out), name)
            for left in out:
                self.assertGreater(len(left), 30)

    def test_what_changed_is_never_left_out(self):
        changed = {"tests/3", "tests/4"}
        for turn in range(3):
            self.assertFalse({"room.3", "room.4"} & set(left_out(self.tests, self.programs, changed, turn)))

    def test_of_very_many_that_changed_another_third_is_left_out_each_time(self):
        names = [f"room.{number}" for number in range(301)]
        tests = {name: [name] for name in names}
        for many in (300, 301):
            changed = set(names[:many])
            left = [changed & set(left_out(tests, set(names), changed, turn)) for turn in range(3)]
            for name in changed:
                self.assertEqual(many > 300, any(name in some for some in left), name)
                self.assertLessEqual(sum(name in some for some in left), 1, name)
        for turn in range(3):  # one that has its turn is run, whether it changed or not
            self.assertFalse([name for name in left[turn] if third_of(name) == turn])

    def test_what_runs_no_program_of_ours_is_never_left_out(self):
        for turn in range(3):
            self.assertEqual([], left_out({"house.readmes": ["python3", "readmes.py"]}, self.programs, set(), turn))

    def test_a_test_is_unreached_where_it_runs_programs_of_ours_of_which_none_changed(self):
        tests = {"vm.a": ["in_vm", "tests/3"], "vm.b": ["in_vm", "tests/5"], "vm.c": ["python3"]}
        self.assertEqual(["vm.b"], unreached(tests, self.programs, {"tests/3"}))

    def test_programs_that_tests_run_are_named_once_and_no_others(self):
        tests = {"room.a": ["run_test", "tests/a"], "room.b": ["run_test", "helper", "tests/a"], "house.c": ["python3", "c.py"]}
        self.assertEqual({"tests/a", "helper"}, run_by(tests, {"tests/a", "helper", "bench"}))

    def test_a_turn_is_the_same_for_the_same_name(self):
        self.assertEqual((0, 1), (third_of("core.servo.servo_loop"), third_of("app.care.page")))


unittest.main()
