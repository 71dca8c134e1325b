// The signals of a document, independent of its items.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <QObject>

namespace mapwright::edit {

/// Keys of items that were added, that changed or have another state (saved, sent, …), and that were removed.
struct DocumentChange {
  std::vector<std::string> added, changed, removed;
  bool everything = false;  // check everything; the lists are empty
  /// Which fields of `changed` may differ, one bit each as in Fields<Item>::all. Their state may differ in
  /// any case.
  std::uint32_t fields = ~std::uint32_t(0);
};

class DocumentEvents : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  ~DocumentEvents() override;

 Q_SIGNALS:
  /// The only signal: covers items, their states, and the state of the whole.
  void changed(const mapwright::edit::DocumentChange& change);
};

}  // namespace mapwright::edit
