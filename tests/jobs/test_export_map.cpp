// A map that is exported under a name that somebody else has taken.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "jobs/export_map.h"
#include "test_program.h"

namespace test_export_map {

using namespace mapwright;

class TestExportMap : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aPictureThatIsKeptBesideKeepsItsPlace() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("view.png"));
    QFile other(path);
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("another's") == 9);
    other.close();
    QImage picture(20, 10, QImage::Format_RGB32);
    picture.fill(Qt::white);
    jobs::ExportRequest request{jobs::ViewExport{picture, {20, 10, 0.05, {0, 0, 0}}},
                                jobs::ExportFormat::ViewPicture, path, true};
    request.existing = disk::Existing::Refuse;
    const jobs::ExportResult refused = jobs::exportMap(request, {});
    QVERIFY2(refused.error.contains(folder.filePath(QStringLiteral("view-1.png"))),
             qPrintable(refused.error));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files),
             (QStringList{QStringLiteral("view-1.pgw"), QStringLiteral("view-1.png"),
                          QStringLiteral("view.png")}));
    QVERIFY(other.open(QIODevice::ReadOnly) && other.readAll() == "another's");
    request.existing = disk::Existing::Replace;
    QVERIFY(jobs::exportMap(request, {}).error.isEmpty());
    QVERIFY(QImage(path).size() == picture.size() &&
            QFile::exists(folder.filePath(QStringLiteral("view.pgw"))));
  }
};

}  // namespace test_export_map

MAPWRIGHT_TEST(test_export_map, TestExportMap, Core)
#include "test_export_map.moc"
