// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/lane.h"

#include "cad2slam/core/vector_registers.h"
#include "ui/views/background_thread.h"

#include <QThreadPool>

#include <condition_variable>
#include <deque>
#include <mutex>

namespace cad2slam {
namespace {

std::unique_ptr<QThreadPool> makeThreads(int most, int started) {
  auto pool = std::make_unique<QThreadPool>();
  pool->setMaxThreadCount(most);
  startLastingThreads(*pool, started);
  return pool;
}

QThreadPool& sharedThreads() {
  constexpr int kMost = 256;  // room for every lane at once: none waits for another one
  static const std::unique_ptr<QThreadPool> pool = makeThreads(kMost, 0);
  return *pool;
}

}  // namespace

struct Lane::State {
  std::mutex mutex;
  std::condition_variable all_done;
  std::deque<std::function<void()>> tasks;  // not begun
  int at_once = 1;
  int threads = 0;  // at work; not 0 while there are tasks
};

Lane::Lane(int at_once, Threads threads) : state_(std::make_shared<State>()) {
  state_->at_once = at_once;
  if (threads == Threads::kOwn) own_ = makeThreads(at_once, at_once);
}

Lane::~Lane() {
  waitForDone();
}

void Lane::start(std::function<void()> task) {
  const std::lock_guard lock(state_->mutex);
  state_->tasks.push_back(std::move(task));
  if (state_->threads == state_->at_once) return;
  ++state_->threads;
  (own_ ? *own_ : sharedThreads()).start([state = state_] { work(state); });
}

void Lane::work(const std::shared_ptr<State>& state) {
  giveWayToWindow();
  clearUpperVectorHalves();  // as whoever started the thread left them
  std::unique_lock lock(state->mutex);
  while (!state->tasks.empty()) {
    std::function<void()> task = std::move(state->tasks.front());
    state->tasks.pop_front();
    lock.unlock();
    task();
    task = nullptr;  // what it holds goes before anybody is told that it is done
    lock.lock();
  }
  --state->threads;
  state->all_done.notify_all();
}

void Lane::waitForDone() {
  std::unique_lock lock(state_->mutex);
  state_->all_done.wait(lock, [this] { return state_->threads == 0; });
}

void Lane::prepareSharedThreads(int count) {
  startLastingThreads(sharedThreads(), count);
}

}  // namespace cad2slam
