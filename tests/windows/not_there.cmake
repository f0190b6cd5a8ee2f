# SPDX-License-Identifier: Apache-2.0
# Tests of rooms that are built for Windows which cannot be tried there, and why.
set(not_there
  core.files                   # asks POSIX who may read a file; files_test.cpp beside this is Windows's own
  core.files.growing_file      # puts itself in the place of POSIX's own functions
  core.files.failing_disk      # the same
  core.files.new_file          # asks POSIX for a process of its own
  core.files.open_file         # asks POSIX for pipes, times and what programs inherit
  core.files.names             # asks POSIX for links and processes
  core.files.held_elsewhere    # asks POSIX for processes and what they have open
  core.files.foreign_folder    # asks POSIX for links; files_test.cpp beside this has those of Windows
  core.libraries               # names libraries as Linux does
  core.processes.helper_on_linux # asks Linux what is refused; processes_test.cpp beside this is Windows's own
  core.guidance.hostile_scenes # reads SVG: core/svg needs lib2geom
  core.servo.servo_loop        # asks Linux's scheduler
  core.servo.snapshot          # the same
  core.servo.real_time         # the same
  core.touch.thread            # asks Linux's scheduler
  core.servo.exit_guard        # ends processes by signals
  device.haply_2diy.found_boards # reads folders as Linux's; windows.found_boards is Windows's own
  device.haply_2diy.board_guard  # runs here, on programs for Windows: windows.board_guard
  device.haply_2diy.serial_port # asks Linux for pseudo-terminals; windows.board_guard opens COM ports
  faces.extra_features         # knows pictures: needs OpenCV
  core.statistics.r_agrees)    # needs R
