// The main function of every test program; each room of tests is one.
#define BOOST_TEST_MODULE tetracone
#include <boost/test/unit_test.hpp>
