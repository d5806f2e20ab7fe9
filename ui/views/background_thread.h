// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

class QThreadPool;

namespace cad2slam {

/// Says that the calling thread, and those it starts from now on, work for the window but must not keep it waiting:
/// where all processors are busy, painting comes first. (QThread's priorities do nothing under Linux's usual
/// scheduler.) Cheap to call again.
void giveWayToWindow();

/// Says that the calling thread, and those it starts from now on, work for a short time and want to begin at once: the
/// window's thread, and the pool of Qt that fills large areas for it. A thread with a shorter slice need not wait until
/// another one has used up its own. To be called before there are other threads.
void comeBeforeBackground();

/// Starts so many threads of a pool, which wait for work from then on, and lets those that it starts later stay as
/// well. Returns before they have all begun.
void startLastingThreads(QThreadPool& pool, int count);

}  // namespace cad2slam
