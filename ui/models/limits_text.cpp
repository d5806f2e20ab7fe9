// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/limits_text.h"

#include "ui/document/judgement.h"
#include "ui/models/number_text.h"

#include <QCoreApplication>

namespace cad2slam {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Limits)
};

}  // namespace

QString limitsText(const ClassLimits& limits) {
  return Text::tr("Judged by the error without it, below %1 anchors by the residual; the larger limit counts:")
             .arg(kLeaveOneOutFrom) +
         QLatin1Char('\n') +
         Text::tr("● OK up to %1 or %2 pixels of the SLAM map")
             .arg(lengthText(limits.ok_m), shortNumberText(limits.ok_cells)) +
         QLatin1Char('\n') +
         Text::tr("◆ Have a look up to %1 or %2 pixels")
             .arg(lengthText(limits.look_m), shortNumberText(limits.look_cells));
}

QString badRuleText() {
  return Text::tr("■ Bad beyond that, if it is also more than %1 times the median or the residual is not OK")
             .arg(shortNumberText(kAgainstMedian)) +
         QLatin1Char('\n') +
         Text::tr("■ From %1 anchors on also bad: not OK and more than %2 standard deviations above the mean")
             .arg(kSpreadFrom)
             .arg(shortNumberText(kSpreads));
}

}  // namespace cad2slam
