#!/usr/bin/env python3
"""Stands for the screen of LinuxCNC: runs programs one after the other and records how they move.

FEEDSCOPE_PROGRAMS: their files, separated by colons. FEEDSCOPE_TRACE: the file to write. FEEDSCOPE_LONGEST_S: what a
program may last (60 s). A line of it is one servo
period: what the HAL file of the configuration says, last the number of the program from 1 on, 0 between programs.
"""
import os
import subprocess
import sys
import time

import linuxcnc

LONGEST_PROGRAM_S = float(os.environ.get("FEEDSCOPE_LONGEST_S", 60))

command = linuxcnc.command()
status = linuxcnc.stat()
errors = linuxcnc.error_channel()


def fail_on_error(program):
    """Ends with the control's own message where it has one."""
    error = errors.poll()
    if error and error[0] in (linuxcnc.NML_ERROR, linuxcnc.OPERATOR_ERROR):
        sys.exit(f"{program}: {error[1]}")


def wait_until_idle(program):
    """Until the interpreter has read everything and nothing moves any more."""
    end = time.monotonic() + LONGEST_PROGRAM_S
    while time.monotonic() < end:
        time.sleep(0.05)
        fail_on_error(program)
        status.poll()
        if status.interp_state == linuxcnc.INTERP_IDLE and status.inpos and status.queue == 0:
            return
    sys.exit(f"{program}: not done after {LONGEST_PROGRAM_S} s")


def run_line(text):
    command.mode(linuxcnc.MODE_MDI)
    command.wait_complete()
    command.mdi(text)
    command.wait_complete(LONGEST_PROGRAM_S)
    wait_until_idle(text)


def name_program(number):
    subprocess.run(["halcmd", "sets", "program", str(number)], check=True)
    time.sleep(0.05)


def main():
    for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
        command.state(state)
        command.wait_complete()
    command.home(-1)
    command.wait_complete()
    sampler = subprocess.Popen(["halsampler", os.environ["FEEDSCOPE_TRACE"]])
    for number, program in enumerate(os.environ["FEEDSCOPE_PROGRAMS"].split(":"), 1):
        run_line("G53 G0 X0 Y0 Z0")
        command.mode(linuxcnc.MODE_AUTO)
        command.wait_complete()
        command.program_open(program)
        name_program(number)
        command.auto(linuxcnc.AUTO_RUN, 0)
        command.wait_complete()
        time.sleep(0.2)
        wait_until_idle(program)
        time.sleep(0.1)
        name_program(0)
    time.sleep(0.3)
    sampler.terminate()
    sampler.wait()


main()
