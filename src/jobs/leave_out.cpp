#include "jobs/leave_out.h"

#include <QCoreApplication>

#include "pbstream/drop.h"
#include "sentences/fault_sentence.h"
#include "words/figures.h"
#include "words/listed.h"

namespace mapwright::jobs {
namespace {

class LeaveOutText {
  Q_DECLARE_TR_FUNCTIONS(LeaveOut)
};

}  // namespace

tl::expected<pbstream::DropReceipt, QString> leaveOut(const QString& from, const map::GraphParts& what,
                                                      const QString& to,
                                                      const std::function<bool()>& cancelled,
                                                      const std::function<void(double)>& progressed) {
  auto receipt = pbstream::drop(from.toStdString(), what, to.toStdString(), cancelled, progressed);
  if (receipt) return std::move(*receipt);
  const QString why = sentences::wordsOf(receipt.error());
  return tl::unexpected(why.contains(to) ? why : words::about(from, why));
}

QStringList leftOutSentences(const pbstream::DropReceipt& receipt, const QString& to) {
  const auto counted = [](std::size_t count) {
    return QString::fromStdString(words::grouped(std::int64_t(count)));
  };
  return {
      LeaveOutText::tr("Left out: trajectories %1, submaps %2, nodes %3, INTER constraints %4, INTRA "
                       "constraints %5; records %6.")
          .arg(counted(receipt.trajectories), counted(receipt.submaps), counted(receipt.nodes),
               counted(receipt.inter), counted(receipt.intra), counted(receipt.records)),
      LeaveOutText::tr("%1 was written, read again and compared. Rewritten: the pose graph%2; every other "
                       "record kept its bytes.")
          .arg(to, receipt.rewritten > 1 ? LeaveOutText::tr(" and the options") : QString()),
      LeaveOutText::tr(
          "No pose has changed: Cartographer optimises them when it loads the file and runs again.")};
}

QStringList damageSentences(const pbstream::DropReceipt& receipt) {
  QStringList said;
  for (const Fault& why : receipt.damaged)
    said << LeaveOutText::tr("Damaged, and copied as it is: %1").arg(sentences::wordsOf(why));
  if (receipt.more_damaged > 0)
    said << LeaveOutText::tr("More records that are damaged and were copied: %1.")
                .arg(QString::fromStdString(words::grouped(std::int64_t(receipt.more_damaged))));
  return said;
}

tl::expected<QStringList, QString> leaveOutSaying(const QString& from, const map::GraphParts& what,
                                                  const QString& to, const std::function<bool()>& cancelled,
                                                  const std::function<void(double)>& progressed) {
  return leaveOut(from, what, to, cancelled, progressed).map([&](const pbstream::DropReceipt& receipt) {
    return leftOutSentences(receipt, to) + damageSentences(receipt);
  });
}

}  // namespace mapwright::jobs
