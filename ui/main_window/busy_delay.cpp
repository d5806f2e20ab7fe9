// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/busy_delay.h"

namespace cad2slam {

BusyDelay::BusyDelay(QObject* parent) : QObject(parent) {
  timer_.setSingleShot(true);
  timer_.setInterval(kShownAfter_ms);
  connect(&timer_, &QTimer::timeout, this, [this] {
    shown_ = true;
    emit becameLong();
  });
}

void BusyDelay::setBusy(bool busy) {
  if (!busy) {
    timer_.stop();
    shown_ = false;
  } else if (!shown_ && !timer_.isActive()) {
    timer_.start();
  }
}

}  // namespace cad2slam
