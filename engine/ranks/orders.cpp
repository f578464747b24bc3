#include "ranks/orders.hpp"

#include <cstring>
#include <type_traits>

#include "base/contracts.hpp"

namespace sandgraph::ranks {

static_assert(std::is_trivially_copyable_v<Order>);

void tell(Team& team, const Order& order) {
    SG_EXPECT(team.rank() == 0);
    std::uint8_t bytes[sizeof(Order)];
    std::memcpy(bytes, &order, sizeof bytes);
    team.broadcast(bytes);
}

Order hear(Team& team) {
    SG_EXPECT(team.rank() != 0);
    std::uint8_t bytes[sizeof(Order)];
    team.broadcast(bytes);
    Order order;
    std::memcpy(&order, bytes, sizeof bytes);
    return order;
}

}  // namespace sandgraph::ranks
