# SPDX-License-Identifier: Apache-2.0
# Declares an arrow that the table does not allow; must stop with a sentence.
cmake_minimum_required(VERSION 3.25)
include(${HOUSE})
tp_check_arrows(tp_geometry DEPENDS tp_guidance)
