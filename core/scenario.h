// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Every header of palpate::scenario.
#include "palpate/scenario/assessment.h"
#include "palpate/scenario/container.h"
#include "palpate/scenario/read.h"
#include "palpate/scenario/scenario.h"
#include "palpate/scenario/write.h"
