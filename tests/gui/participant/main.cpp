// The nurse's screens as logic: no widget, no display.
#include <QCoreApplication>
#include <csignal>
#include <gtest/gtest.h>

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // as the programs do
  const QCoreApplication application(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
