// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

namespace cad2slam {

class MessageBar;
class Session;
struct ChangeEvent;

/// Tells of keys and views once each, when they first are of use; who does not want to be told says so once.
class Tips : public QObject {
  Q_OBJECT

 public:
  Tips(Session& session, MessageBar& messages, QObject* parent);

  static void setWanted(bool wanted);

 private:
  void onChanged(const ChangeEvent& event);
  void tell(const char* key, const QString& text);

  Session& session_;
  MessageBar& messages_;
};

}  // namespace cad2slam
