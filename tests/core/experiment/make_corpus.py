#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what fuzz_trial_table begins from beside a table of two trials: tables of which something is wrong.

    tests/core/experiment/make_corpus.py    writes tests/core/experiment/trial_corpus
"""
from pathlib import Path

CORPUS = Path(__file__).resolve().parent / "trial_corpus"
HEAD = "experiment,participant,trial,repetition,training,shape,radius,error_mm,time_s,answer,correct,repeated,seed\n"
TRIAL = "small,7,12,2,no,square,50,,7.25,square,yes,no,18446744073709551615\n"


def main():
    made = {"nothing": "",
            "no_trials": HEAD,
            "no_trials_and_no_end": HEAD[:-1],
            "torn": HEAD + TRIAL + TRIAL[:30],
            "of_another_experiment": HEAD + TRIAL.replace("small", "large"),
            "older_columns": HEAD.replace(",seed", "") + TRIAL.replace(",18446744073709551615", ""),
            "newer_columns": HEAD[:-1] + ",device\n" + TRIAL[:-1] + ",mouse\n",
            "a_cell_too_many": HEAD + TRIAL[:-1] + ",\n",
            "a_quotation_without_end": HEAD + '"' + TRIAL,
            "ends_of_another_system": (HEAD + TRIAL).replace("\n", "\r\n"),
            "numbers_too_large": HEAD + TRIAL.replace(",7,", ",9999999999999999999999,"),
            "a_seed_too_large": HEAD + TRIAL.replace("18446744073709551615", "18446744073709551616"),
            "no_time": HEAD + TRIAL.replace("7.25", "nan"),
            "a_level_that_there_is_not": HEAD + TRIAL.replace(",square,50", ",star,50"),
            "a_cell_without_end": HEAD + TRIAL.replace("small", "s" * 4000),
            "fifty_trials": HEAD + 50 * TRIAL}
    for name, text in made.items():
        (CORPUS / name).write_bytes(text.encode())


if __name__ == "__main__":
    main()
