//! Numbers by the group that they belong to.

/// Numbers of groups, those of one group side by side and in their order.
#[derive(Debug)]
pub(crate) struct Grouped {
    /// Where each group's begin in `numbers`, and the end of the last one's.
    begins: Vec<u32>,
    numbers: Vec<u32>,
}

impl Grouped {
    /// Fewer than 2^32 pairs of a group, counted from 0 and below `groups`, and a number.
    pub fn new(groups: usize, pairs: impl Iterator<Item = (u32, u32)> + Clone) -> Grouped {
        let mut begins = vec![0_u32; groups + 1];
        pairs.clone().for_each(|(group, _)| begins[group as usize + 1] += 1);
        for group in 0..groups {
            begins[group + 1] += begins[group];
        }
        let mut ends = begins.clone();
        let mut numbers = vec![0; begins[groups] as usize];
        for (group, number) in pairs {
            let end = &mut ends[group as usize];
            numbers[*end as usize] = number;
            *end += 1;
        }
        Grouped { begins, numbers }
    }

    /// How many groups there are.
    pub fn groups(&self) -> usize {
        self.begins.len() - 1
    }

    /// The numbers of a group.
    pub fn of(&self, group: u32) -> &[u32] {
        let [begin, end] = [group, group + 1].map(|k| self.begins[k as usize] as usize);
        &self.numbers[begin..end]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_with_their_group_in_their_order() {
        let pairs = [(2, 7), (0, 5), (2, 3), (0, 9)];
        let grouped = Grouped::new(4, pairs.into_iter());
        assert_eq!(grouped.groups(), 4);
        let all = [0, 1, 2, 3].map(|group| grouped.of(group).to_vec());
        assert_eq!(all, [vec![5, 9], vec![], vec![7, 3], vec![]]);
        assert_eq!(Grouped::new(0, std::iter::empty()).groups(), 0);
    }
}
