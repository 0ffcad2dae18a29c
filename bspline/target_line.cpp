// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/target_line.h"
