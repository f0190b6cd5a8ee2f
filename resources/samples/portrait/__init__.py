# SPDX-License-Identifier: Apache-2.0
"""Drawn portraits with exactly known contours: geometry, relief, features, hair and the scenes made of them."""
