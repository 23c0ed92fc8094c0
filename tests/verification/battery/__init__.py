"""The battery: cases with answers that are known from elsewhere."""
