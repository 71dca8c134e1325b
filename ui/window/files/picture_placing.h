// Where a picture lies in the world: from the map.yaml beside it, or by asking.
#pragma once

#include <functional>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>

#include "work/workers.h"

class QWidget;

namespace mapwright::window {

class PictureDialog;

class PicturePlacing : public QObject {
  Q_OBJECT
 public:
  using Then = std::function<void(const QString& address)>;

  /// `yamls_naming`: the map.yaml files beside a picture that name it as theirs; looks at the disk, called on
  /// any thread. Null: it is always asked.
  PicturePlacing(QWidget* window, std::function<QStringList(const QString& picture)> yamls_naming,
                 std::shared_ptr<work::Workers> workers);

  /// Goes on with the address of the map that the picture is. Only the last one that was wanted is gone on
  /// with.
  void place(const QString& path, const QString& accept_text, const Then& then);
  PictureDialog* dialog() const;  // null: not open

 private:
  void ask(const QString& path, const QStringList& named_by, const QString& accept_text, const Then& then);

  QWidget* window_;
  std::function<QStringList(const QString& picture)> yamls_naming_;
  QPointer<PictureDialog> dialog_;
  quint64 asked_ = 0;
  work::Share share_;  // last: it waits for what looks
};

}  // namespace mapwright::window
