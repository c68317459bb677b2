#include "common/state_bytes.hpp"

#include <gtest/gtest.h>

namespace cosurge {
namespace {

TEST(StateBytes, ComeBackInTheirOrder) {
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(3, 4);
  const std::vector<std::int32_t> list = {1, -2, 3};
  StateWriter writer;
  writer.put(2.5);
  writer.put(list);
  put_sized(writer, matrix);
  writer.put(std::string("words"));
  const std::string bytes = writer.take();

  StateReader reader(bytes);
  double number = 0;
  std::vector<std::int32_t> same_list;
  Eigen::MatrixXd same_matrix;
  std::string words;
  reader.get(number);
  reader.get(same_list);
  get_sized(reader, same_matrix);
  reader.get(words);
  reader.finish();
  EXPECT_EQ(number, 2.5);
  EXPECT_EQ(same_list, list);
  EXPECT_EQ(same_matrix, matrix);
  EXPECT_EQ(words, "words");
}

// States of another build: invalid sizes.
TEST(StateBytes, OfAnotherLayoutAreRefusedWhateverTheirNumbersSay) {
  Eigen::MatrixXd matrix;
  std::vector<double> list;
  for (const std::int64_t rows : {std::int64_t{-1}, std::int64_t{1} << 40, std::int64_t{1} << 62})
    for (const std::int64_t columns : {std::int64_t{-3}, std::int64_t{2}, std::int64_t{1} << 50}) {
      StateWriter writer;
      writer.put(rows);
      writer.put(columns);
      const std::string bytes = writer.take();
      StateReader sized(bytes), counted(bytes);
      EXPECT_THROW(get_sized(sized, matrix), Error) << rows << " x " << columns;
      EXPECT_THROW(counted.get(list), Error) << rows;
    }
}

TEST(StateBytes, MayNotBeLeftOver) {
  StateReader reader("1234");
  EXPECT_THROW(reader.finish(), Error);
}

}  // namespace
}  // namespace cosurge
